/* Exercise 14.2.  Touching by a hair: overlap after rounding to float.
 *
 * Two intervals of a line, first[0] <= first[1] and second[0] <= second[1], are
 * given in doubles, finite and of an absolute value below 1.  Answer whether
 * they overlap after each of their ends has been rounded to the nearest float.
 * Intervals are closed: those that touch overlap.
 *
 * If the intervals themselves overlap, your answer must be true; convince
 * yourself that it is.
 *
 * Section: Rounding keeps the order.
 *
 * Hint 1: (float)x is the float nearest to x.
 * Hint 2: Intervals do not overlap if one of them begins after the end of the
 *     other.
 * Hint 3: A middle and half a length are sums.  To round them is not to round
 *     the ends.
 */
#include <float.h>
#include <math.h>
#include <stdbool.h>

bool touch(const double first[2], const double second[2])
{
#if defined TF_SOLUTION
    return (float)first[0] <= (float)second[1] &&
           (float)second[0] <= (float)first[1];
#elif defined TF_WRONG_1 // does not round
    return first[0] <= second[1] && second[0] <= first[1];
#elif defined TF_WRONG_2 // takes intervals that touch for apart
    return (float)first[0] < (float)second[1] &&
           (float)second[0] < (float)first[1];
#elif defined TF_WRONG_3 // rounds outward
    return nextafterf((float)first[0], -1) <= nextafterf((float)second[1], 1) &&
           nextafterf((float)second[0], -1) <= nextafterf((float)first[1], 1);
#elif defined TF_WRONG_4 // rounds middles and half lengths
    float middle = (float)(first[0] / 2 + first[1] / 2);
    float other = (float)(second[0] / 2 + second[1] / 2);
    float half = (float)(first[1] / 2 - first[0] / 2);
    float other_half = (float)(second[1] / 2 - second[0] / 2);
    return fabsf(middle - other) <= half + other_half;
#elif defined TF_WRONG_5 // adds a tolerance that is as good as any other
    return first[0] <= second[1] + FLT_EPSILON &&
           second[0] <= first[1] + FLT_EPSILON;
#else
    // Your turn: everything is a candidate.
    return true;
#endif
}
