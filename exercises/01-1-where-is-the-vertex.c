/* Exercise 1.1.  Where is the vertex at time t?
 *
 * A vertex moves along a worldline, in a straight line and at a constant rate,
 * from its event at t = 0 to its event at t = 1.  Find where it is at time t,
 * 0 <= t <= 1, on the axes 0 to axes - 1, and write nothing else: in the plane
 * there is no position[2].  At t = 0 and at t = 1 the answer must be the stored
 * position to the last bit.
 *
 * Section: Events and worldlines.
 *
 * Hint 1: At t = 0 all of the answer comes from at[0], at t = 1 all of it from
 *     at[1].  What share does each have in between?
 * Hint 2: The shares are 1 - t and t.
 * Hint 3: start + t * (end - start) looks the same, but its difference is
 *     rounded: at t = 1 it may miss the end.  Multiply first, then add.
 */
#include "geometry/event.h"

void position_at(int axes, const tf_worldline *line, double t,
                 double position[])
{
#if defined TF_SOLUTION
    for (int k = 0; k < axes; k++)
        position[k] = (1 - t) * line->at[0].x[k] + t * line->at[1].x[k];
#elif defined TF_WRONG_1 // takes the end for a displacement
    for (int k = 0; k < axes; k++)
        position[k] = line->at[0].x[k] + t * line->at[1].x[k];
#elif defined TF_WRONG_2 // swaps the shares: runs backward
    for (int k = 0; k < axes; k++)
        position[k] = t * line->at[0].x[k] + (1 - t) * line->at[1].x[k];
#elif defined TF_WRONG_3 // misses the end by a rounding
    for (int k = 0; k < axes; k++)
        position[k] =
            line->at[0].x[k] + t * (line->at[1].x[k] - line->at[0].x[k]);
#elif defined TF_WRONG_4 // writes as in space, in the plane, too
    for (int k = 0; k < TF_AXES; k++)
        position[k] = (1 - t) * line->at[0].x[k] + t * line->at[1].x[k];
#else
    // Your turn.  For now the vertex never leaves the origin.
    for (int k = 0; k < axes; k++)
        position[k] = 0;
#endif
}
