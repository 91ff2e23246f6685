/* Exercise 3.2.  Time of impact.
 *
 * The barycentric coordinates of the event that two simplices have in common
 * are known up to a common factor: c[i] belongs to event number i of the pair.
 * They have not been turned: those of one side are >= 0 and those of the other
 * <= 0.  Find the time of that event.
 *
 * Section: Time of impact.
 *
 * Hint 1: Divided by their sum, the coordinates of the one side are weights
 *     that add up to 1.  So are those of the other, divided by theirs.
 * Hint 2: The common event is the weighted mean of the events of either side,
 *     and so its time is the weighted mean of their times, which are 0 or 1.
 * Hint 3: Sum over S only, where side[i] is +1: the sum of c t by the sum of
 *     c.  Over both sides the sum of c is zero.
 */
#include "spacetime/complementary.h"

double time_of_impact(const tf_pair *pair, const double c[])
{
    double late = 0, all = 0;
#if defined TF_SOLUTION
    for (int i = 0; i < pair->count; i++)
        if (pair->side[i] > 0) {
            late += pair->event[i]->t * c[i];
            all += c[i];
        }
    return late / all;
#elif defined TF_WRONG_1 // sums both sides: 0 / 0
    for (int i = 0; i < pair->count; i++) {
        late += pair->event[i]->t * c[i];
        all += c[i];
    }
    return late / all;
#elif defined TF_WRONG_2 // measures the time that is left
    for (int i = 0; i < pair->count; i++)
        if (pair->side[i] > 0) {
            late += (1 - pair->event[i]->t) * c[i];
            all += c[i];
        }
    return late / all;
#elif defined TF_WRONG_3 // forgets the common factor
    for (int i = 0; i < pair->count; i++)
        if (pair->side[i] > 0)
            late += pair->event[i]->t * c[i];
    return late + all;
#else
    // Your turn.
    return late + all;
#endif
}
