/* Exercise 7.1.  The first of four.
 *
 * Two moving edges have two simplices each.  Find what is known of their first
 * meeting, by tf_meet and tf_meeting_earlier.  The edges are in general
 * position, and the arithmetic knows all signs.
 *
 * Section: Two sheets, four pairs.
 *
 * Hint 1: Sweep both edges with tf_sweep; tf_pair_of makes a pair of a simplex
 *     of the one and a simplex of the other, in 3 axes.
 * Hint 2: Any simplex of the one may meet any of the other: four pairs.  And
 *     the first pair that meets need not be the one that meets first.
 * Hint 3: Start with tf_meeting_apart, and in two nested loops replace it by
 *     the earlier of itself and the meeting of the pair.
 */
#include "spacetime/meet.h"

tf_meeting first_of_four(const tf_arithmetic *arithmetic,
                         const tf_worldline first[2],
                         const tf_worldline second[2])
{
    tf_simplex s[2], r[2];
    tf_sweep(2, first, s);
    tf_sweep(2, second, r);
    tf_meeting meeting = tf_meeting_apart;
#if defined TF_SOLUTION
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            tf_meeting own = tf_meet(arithmetic, &pair);
            meeting = tf_meeting_earlier(&meeting, &own);
        }
#elif defined TF_WRONG_1 // believes that a simplex meets only its like
    for (int i = 0; i < 2; i++) {
        tf_pair pair = tf_pair_of(&s[i], &r[i], 3);
        tf_meeting own = tf_meet(arithmetic, &pair);
        meeting = tf_meeting_earlier(&meeting, &own);
    }
#elif defined TF_WRONG_2 // stops at the first pair that meets
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            meeting = tf_meet(arithmetic, &pair);
            if (meeting.verdict == TF_HIT)
                return meeting;
        }
#elif defined TF_WRONG_3 // keeps the last pair that meets
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            tf_meeting own = tf_meet(arithmetic, &pair);
            if (own.verdict == TF_HIT)
                meeting = own;
        }
#else
    // Your turn: here is one pair of the four.
    tf_pair pair = tf_pair_of(&s[0], &r[0], 3);
    meeting = tf_meet(arithmetic, &pair);
#endif
    return meeting;
}
