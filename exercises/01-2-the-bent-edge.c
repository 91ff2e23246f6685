/* Exercise 1.2.  The bent edge, cut at a time.
 *
 * An edge sweeps out two triangles of space-time.  Cut them at time t,
 * 0 < t < 1: the slice of each is a straight piece, and the two pieces share an
 * end, the crease.  So at time t the edge runs from corner[0], where vertex 0
 * is, through the crease, corner[1], to corner[2], where vertex 1 is.  Find the
 * three corners.
 *
 * Section: Bent in mid-step.
 *
 * Hint 1: List the events of both triangles.  Which side do they share?
 * Hint 2: They share the segment from vertex 0 at t = 0 to vertex 1 at t = 1.
 *     Where is it at time t?
 * Hint 3: It is at (1 - t) edge[0].at[0] + t edge[1].at[1], on each axis.
 */
#include "geometry/sweep.h"

/// The point at the time t of the segment between two events, the first at
/// t = 0 and the second at t = 1.
static void cut(const tf_event *start, const tf_event *end, double t,
                double point[2])
{
    for (int k = 0; k < 2; k++)
        point[k] = (1 - t) * start->x[k] + t * end->x[k];
}

void bent_edge(const tf_worldline edge[2], double t, double corner[3][2])
{
    cut(&edge[0].at[0], &edge[0].at[1], t, corner[0]);
#if defined TF_SOLUTION
    cut(&edge[0].at[0], &edge[1].at[1], t, corner[1]);
    cut(&edge[1].at[0], &edge[1].at[1], t, corner[2]);
#elif defined TF_WRONG_1 // takes the other diagonal
    cut(&edge[1].at[0], &edge[0].at[1], t, corner[1]);
    cut(&edge[1].at[0], &edge[1].at[1], t, corner[2]);
#elif defined TF_WRONG_2 // keeps the edge straight
    cut(&edge[1].at[0], &edge[1].at[1], t, corner[2]);
    for (int k = 0; k < 2; k++)
        corner[1][k] = (corner[0][k] + corner[2][k]) / 2;
#elif defined TF_WRONG_3 // bends where the segment is in the middle of the step
    cut(&edge[0].at[0], &edge[1].at[1], 0.5, corner[1]);
    cut(&edge[1].at[0], &edge[1].at[1], t, corner[2]);
#else
    // Your turn: corner[0] is right, the others are not.
    cut(&edge[0].at[0], &edge[0].at[1], t, corner[1]);
    cut(&edge[0].at[0], &edge[0].at[1], t, corner[2]);
#endif
}
