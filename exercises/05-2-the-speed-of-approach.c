/* Exercise 5.2.  The speed of approach.
 *
 * A point meets an edge: the point's worldline meets a triangle of the edge's
 * sweep.  Find the component along `normal` of the velocity of the point
 * relative to the edge, as a length per step.
 *
 * Section: Velocity and speed.
 *
 * Hint 1: All of a simplex moves with one velocity, that of its mover, the only
 *     vertex with both its events there.
 * Hint 2: The mover's events are event[mover], at t = 0, and event[mover + 1],
 *     at t = 1.  This holds for the point's worldline, too.
 * Hint 3: Take the point's displacement minus that of the edge's mover, and
 *     multiply by the normal, axis by axis.
 */
#include "spacetime/sweep.h"

/// The displacement of the mover of a simplex, along an axis.
static double displacement(const tf_simplex *simplex, int axis)
{
#if defined TF_WRONG_1 // from the first event to the last: of two vertices
    return simplex->event[simplex->count - 1]->x[axis] -
           simplex->event[0]->x[axis];
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    return simplex->event[simplex->mover + 1]->x[axis] -
           simplex->event[simplex->mover]->x[axis];
#else
    // Your turn: which two events?
    return simplex->event[0]->x[axis] - simplex->event[0]->x[axis];
#endif
}

double speed_of_approach(const tf_simplex *point, const tf_simplex *edge,
                         const double normal[2])
{
    double speed = 0;
    for (int k = 0; k < 2; k++)
#if defined TF_WRONG_2 // of the edge relative to the point
        speed += (displacement(edge, k) - displacement(point, k)) * normal[k];
#elif defined TF_WRONG_3 // as if the edge were at rest
        speed += displacement(point, k) * normal[k];
#elif defined TF_SOLUTION || defined TF_WRONG_1
        speed += (displacement(point, k) - displacement(edge, k)) * normal[k];
#else
        // Your turn: of the point relative to the edge.
        speed += displacement(point, k);
#endif
    return speed;
}
