/* Exercise 3.3.  A point against an edge, in the frame of the point.
 *
 * From every event of the edge e0 e1 subtract the position of the point at the
 * same time.  Now the point is at rest at the origin, and the question is
 * whether the origin is in one of two triangles of the plane, those of e0, e1,
 * e1' and of e0, e0', e1' as seen from the point.  Touching counts.  The
 * coordinates are small integers, and neither triangle has zero area.
 *
 * Section: In the frame of the point.
 *
 * Hint 1: The origin is in the triangle p q r if it does not lie to the left of
 *     one side and to the right of another, going around p, q, r.
 * Hint 2: Seen from the origin, the turn from p to q has the sign of cross(p,
 *     q).  Take the three of a triangle in a cycle: pq, qr, rp.
 * Hint 3: Zeros agree with both signs: only a positive one beside a negative
 *     one means outside.  At its end your file tries both triangles: one is
 *     enough for a hit.
 */
#include "geometry/sweep.h"

#include <stdbool.h>

static double cross(const double p[2], const double q[2])
{
    return p[0] * q[1] - p[1] * q[0];
}

static bool holds_origin(const double p[2], const double q[2],
                         const double r[2])
{
    double pq = cross(p, q), qr = cross(q, r), rp = cross(r, p);
#if defined TF_WRONG_2 // touching does not count
    return (pq > 0 && qr > 0 && rp > 0) || (pq < 0 && qr < 0 && rp < 0);
#elif defined TF_WRONG_3 // assumes that all triangles turn left
    return pq >= 0 && qr >= 0 && rp >= 0;
#elif defined TF_SOLUTION || defined TF_WRONG_1
    return (pq >= 0 && qr >= 0 && rp >= 0) || (pq <= 0 && qr <= 0 && rp <= 0);
#else
    // Your turn, part two: whether the origin is in the triangle p q r.
    return pq > qr && qr > rp;
#endif
}

bool point_meets_edge(const tf_worldline *point, const tf_worldline edge[2])
{
    double p[2][2][2]; // [vertex][time]: the edge in the frame of the point
    for (int v = 0; v < 2; v++)
        for (int t = 0; t < 2; t++)
            for (int k = 0; k < 2; k++)
#if defined TF_WRONG_1 // subtracts where the point started, not where it is
                p[v][t][k] = edge[v].at[t].x[k] - point->at[0].x[k];
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
                p[v][t][k] = edge[v].at[t].x[k] - point->at[t].x[k];
#else
                // Your turn, part one: subtract the position of the point.
                p[v][t][k] = edge[v].at[t].x[k];
#endif
    return holds_origin(p[0][0], p[1][0], p[1][1]) ||
           holds_origin(p[0][0], p[0][1], p[1][1]);
}
