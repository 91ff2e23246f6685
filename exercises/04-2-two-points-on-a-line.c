/* Exercise 4.2.  When do two points on a line meet?
 *
 * Two points move along one line, each at its own constant velocity, from p[0]
 * and q[0] at t = 0 to p[1] and q[1] at t = 1.  When do they first meet?
 * Return the time, or -1 if they do not meet.
 *
 * Section: Down to a line.
 *
 * Hint 1: Look at how far q is ahead of p at both ends of the step.  When can
 *     that distance have been zero?
 * Hint 2: The distance at time t is (1 - t) d0 + t d1.  It is zero within the
 *     step unless d0 and d1 are both positive or both negative; then
 *     t = d0 / (d0 - d1).
 * Hint 3: If both are zero the points move together, and the quotient is 0 / 0.
 *     When do they first meet then?
 */
#include "intersect/cascade.h"

double first_meeting(const double p[2], const double q[2])
{
    double d0 = q[0] - p[0], d1 = q[1] - p[1];
#if defined TF_SOLUTION
    if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0))
        return -1;
    return d0 == 0 ? 0 : d0 / (d0 - d1);
#elif defined TF_WRONG_1 // divides 0 by 0 where they move together
    if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0))
        return -1;
    return d0 / (d0 - d1);
#elif defined TF_WRONG_2 // confuses "parallel" with "apart"
    if (d0 == d1)
        return -1;
    double t = d0 / (d0 - d1);
    return t >= 0 && t <= 1 ? t : -1;
#elif defined TF_WRONG_3 // reports meetings before and after the step
    return d0 == 0 ? 0 : d0 == d1 ? -1 : d0 / (d0 - d1);
#elif defined TF_WRONG_4 // excludes the ends of the step
    return d0 * d1 < 0 ? d0 / (d0 - d1) : -1;
#else
    // Your turn: this finds only those that meet at the end.
    return d1 == 0 && d0 != 0 ? 1 : -1;
#endif
}
