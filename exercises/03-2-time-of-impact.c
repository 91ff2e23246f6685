/* Exercise 3.2.  The time of impact from barycentric coordinates.
 *
 * The barycentric coordinates of the event that two simplices have in common
 * are known up to a common factor: c[i] belongs to event number i of the pair.
 * They have not been turned: none of one operand is negative, and none of the
 * other is positive.  Find the time of that event.
 *
 * Section: Time of impact.
 *
 * Hint 1: Divided by their sum, the coordinates of one operand are barycentric
 *     coordinates that add up to 1.  So are those of the other, divided by
 *     theirs.
 * Hint 2: The common event is the weighted mean of the events of either
 *     operand, and so its time is the weighted mean of their times, which are 0
 *     or 1.
 * Hint 3: Sum over S only, where operand[i] is +1: the sum of c t divided by
 *     the sum of c.  Over both operands the sum of c is zero.
 */
#include "intersect/complementary.h"

double time_of_impact(const tf_pair *pair, const double c[])
{
    double end = 0, all = 0;
#if defined TF_SOLUTION
    for (int i = 0; i < pair->count; i++)
        if (pair->operand[i] > 0) {
            end += pair->event[i]->t * c[i];
            all += c[i];
        }
    return end / all;
#elif defined TF_WRONG_1 // sums over both operands: 0 / 0
    for (int i = 0; i < pair->count; i++) {
        end += pair->event[i]->t * c[i];
        all += c[i];
    }
    return end / all;
#elif defined TF_WRONG_2 // measures the time that is left
    for (int i = 0; i < pair->count; i++)
        if (pair->operand[i] > 0) {
            end += (1 - pair->event[i]->t) * c[i];
            all += c[i];
        }
    return end / all;
#elif defined TF_WRONG_3 // forgets the common factor
    for (int i = 0; i < pair->count; i++)
        if (pair->operand[i] > 0)
            end += pair->event[i]->t * c[i];
    return end + all;
#else
    // Your turn.
    return end + all;
#endif
}
