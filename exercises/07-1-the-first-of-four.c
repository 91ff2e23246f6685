/* Exercise 7.1.  The first of four intersections of two sweeps.
 *
 * The sweeps of two moving edges have two simplices each.  Find their first
 * intersection with tf_intersect and tf_intersection_earlier.  The edges are in
 * general position, and the arithmetic is exact.
 *
 * Section: Two sheets, four pairs.
 *
 * Hint 1: Sweep both edges with tf_sweep; tf_pair_of makes a pair of one
 *     simplex from each sweep, with 3 axes.
 * Hint 2: Either simplex of one edge may intersect either simplex of the other,
 *     which makes four pairs.  The first of these pairs that intersects need
 *     not be the one that intersects first in time.
 * Hint 3: Start with tf_intersection_apart, and in two nested loops replace it
 *     with the earlier of itself and the intersection of the pair.
 */
#include "intersect/cascade.h"

tf_intersection first_of_four(const tf_arithmetic *arithmetic,
                              const tf_worldline first[2],
                              const tf_worldline second[2])
{
    tf_simplex s[2], r[2];
    tf_sweep(2, first, s);
    tf_sweep(2, second, r);
    tf_intersection meeting = tf_intersection_apart;
#if defined TF_SOLUTION
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            tf_intersection own =
                tf_intersect(arithmetic, &pair, TF_WITH_POINT);
            meeting = tf_intersection_earlier(&meeting, &own);
        }
#elif defined TF_WRONG_1 // pairs only simplices with the same pivot
    for (int i = 0; i < 2; i++) {
        tf_pair pair = tf_pair_of(&s[i], &r[i], 3);
        tf_intersection own = tf_intersect(arithmetic, &pair, TF_WITH_POINT);
        meeting = tf_intersection_earlier(&meeting, &own);
    }
#elif defined TF_WRONG_2 // stops at the first pair that intersects
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            meeting = tf_intersect(arithmetic, &pair, TF_WITH_POINT);
            if (meeting.verdict == TF_HIT)
                return meeting;
        }
#elif defined TF_WRONG_3 // keeps the last pair that intersects
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            tf_intersection own =
                tf_intersect(arithmetic, &pair, TF_WITH_POINT);
            if (own.verdict == TF_HIT)
                meeting = own;
        }
#else
    // Your turn: here is one pair of the four.
    tf_pair pair = tf_pair_of(&s[0], &r[0], 3);
    meeting = tf_intersect(arithmetic, &pair, TF_WITH_POINT);
#endif
    return meeting;
}
