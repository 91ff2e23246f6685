/* Exercise 10.3.  Do an edge and a triangle on a grid intersect?
 *
 * An edge and a triangle of a mesh were rounded to a grid: do they intersect?
 * All coordinates are integers below 2^19 in absolute value, everything is at
 * one time, and the five points do not lie in one plane.  Edge and triangle are
 * closed: touching counts.  Answer TF_HIT or TF_APART.
 *
 * Section: What rounding breaks.
 *
 * Hint 1: Two and three points are complementary in space: 2 + 3 = 3 + 2.
 * Hint 2: tf_pair_of is for sweeps.  Fill a tf_pair yourself: all events are at
 *     the start, the edge is operand +1 and the triangle operand -1, and there
 *     are three axes, 0, 1 and 2.
 * Hint 3: tf_complementary_intersect returns false if all signs are zero, that
 *     is, if everything lies in one plane.  That cannot be; any verdict will do
 *     there.
 */
#include "arithmetic/functions.h"
#include "arithmetic/integer.h"
#include "intersect/complementary.h"

tf_verdict edge_intersects_triangle(const tf_event edge[2],
                                    const tf_event triangle[3])
{
#if defined TF_SOLUTION || defined TF_WRONG_1
    tf_pair pair = {
        .count = 5,
        .start_count = 5,
        .event = {&edge[0], &edge[1], &triangle[0], &triangle[1], &triangle[2]},
        .operand = {+1, +1, -1, -1, -1},
        .axes = 3,
        .axis = {0, 1, 2}};
    tf_intersection found;
    bool decided = tf_complementary_intersect(&tf_integer64, &pair,
                                              TF_ONLY_VERDICT, &found);
#endif
#if defined TF_SOLUTION
    return decided ? found.verdict : TF_UNDECIDED;
#elif defined TF_WRONG_1 // touching does not count
    if (!decided)
        return TF_UNDECIDED;
    return found.classification == TF_GENERIC ? found.verdict : TF_APART;
#elif defined TF_WRONG_2 || defined TF_WRONG_3
    int side[2];
    for (int i = 0; i < 2; i++) {
        tf_differences d = {.n = 3, .axis = {0, 1, 2}};
        for (int j = 0; j < 3; j++) {
            d.to[j] = &triangle[j];
            d.from[j] = &edge[i];
        }
        side[i] = (int)tf_integer64.sign(&d);
    }
#if defined TF_WRONG_2 // the plane of the triangle is larger than the triangle
    return side[0] * side[1] > 0 ? TF_APART : TF_HIT;
#else                  // confuses the triangle with its box
    if (side[0] * side[1] > 0)
        return TF_APART;
    for (int k = 0; k < 3; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            bool beyond = true;
            for (int i = 0; i < 2; i++)
                for (int j = 0; j < 3; j++)
                    beyond &= sign * (edge[i].x[k] - triangle[j].x[k]) > 0;
            if (beyond)
                return TF_APART;
        }
    return TF_HIT;
#endif
#else
    // Your turn: this is right when nothing touches.
    return TF_APART;
#endif
}
