/* Exercise 8.2.  Even or odd: crossings at the end from contacts.
 *
 * An edge and a triangle without a common vertex move, in general position.
 * Whether they cross at the start is given.  Find out whether they cross at the
 * end, without looking at the end: from the number of intersections of pairs of
 * simplices, of the ends of the edge with the triangle and of the edge with the
 * triangle's edges.
 *
 * Section: Even and odd.
 *
 * Hint 1: The number of crossings at the start, the number at the end and the
 *     number of intersections add up to an even number.
 * Hint 2: count_meetings counts pairs of simplices.  You need to count two
 *     points against the triangle and the edge against three edges.
 * Hint 3: A point is an element with one vertex, and &edge[v] is an array of one
 *     worldline.
 */
#include "intersect/cascade.h"

/// How many pairs of a simplex of each intersect.  The two elements have four
/// vertices together.
static int count_meetings(const tf_arithmetic *arithmetic, int vertices,
                          const tf_worldline first[], int others,
                          const tf_worldline second[])
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(vertices, first, s);
    tf_sweep(others, second, r);
    int count = 0;
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < others; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], 3);
            tf_intersection found =
                tf_intersect(arithmetic, &pair, TF_ONLY_VERDICT);
            count += found.verdict == TF_HIT;
        }
    return count;
}

bool cross_at_end(const tf_arithmetic *arithmetic, bool cross_at_start,
                  const tf_worldline edge[2], const tf_worldline triangle[3])
{
    int count = cross_at_start;
#if defined TF_WRONG_3 // forgets the crossing at the start
    count = 0;
#endif
    // In the triangle's order of vertices, in which it sweeps, too.
#if defined TF_WRONG_2 // goes around: reverses the order of the last edge
    static const int side[3][2] = {{0, 1}, {1, 2}, {2, 0}};
#else
    static const int side[3][2] = {{0, 1}, {0, 2}, {1, 2}};
#endif
#if defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    for (int v = 0; v < 2; v++)
        count += count_meetings(arithmetic, 1, &edge[v], 3, triangle);
    for (int i = 0; i < 3; i++) {
        tf_worldline other[2] = {triangle[side[i][0]], triangle[side[i][1]]};
        count += count_meetings(arithmetic, 2, edge, 2, other);
    }
#elif defined TF_WRONG_1 // counts elements, however often they meet
    for (int v = 0; v < 2; v++)
        count += count_meetings(arithmetic, 1, &edge[v], 3, triangle) > 0;
    for (int i = 0; i < 3; i++) {
        tf_worldline other[2] = {triangle[side[i][0]], triangle[side[i][1]]};
        count += count_meetings(arithmetic, 2, edge, 2, other) > 0;
    }
#elif defined TF_WRONG_4 // believes that only points can get through
    for (int v = 0; v < 2; v++)
        count += count_meetings(arithmetic, 1, &edge[v], 3, triangle);
    count += 0 * side[0][0];
#else
    // Your turn: this is one of the five counts.
    tf_worldline other[2] = {triangle[side[0][0]], triangle[side[0][1]]};
    count += count_meetings(arithmetic, 2, edge, 2, other);
#endif
    return count % 2 == 1;
}
