/* Exercise 5.2.  The normal velocity of a contact.
 *
 * A point meets an edge: the point's worldline intersects a triangle of the
 * edge's sweep.  Find the component along `normal` of the velocity of the point
 * relative to the edge, in units of length per step.
 *
 * Section: Relative and normal velocity.
 *
 * Hint 1: All of a simplex moves with one velocity, that of its pivot, the only
 *     vertex both of whose events belong to it.
 * Hint 2: The pivot's events are event[pivot], at t = 0, and event[pivot + 1],
 *     at t = 1.  This holds for the point's worldline, too.
 * Hint 3: Take the point's displacement minus that of the edge's pivot, and
 *     multiply by the normal, axis by axis.
 */
#include "geometry/sweep.h"

/// The displacement of the pivot of a simplex, along an axis.
static double displacement(const tf_simplex *simplex, int axis)
{
#if defined TF_WRONG_1 // from the first event to the last: of two vertices
    return simplex->event[simplex->count - 1]->x[axis] -
           simplex->event[0]->x[axis];
#elif defined TF_SOLUTION || defined TF_WRONG_2 || defined TF_WRONG_3
    return simplex->event[simplex->pivot + 1]->x[axis] -
           simplex->event[simplex->pivot]->x[axis];
#else
    // Your turn: which two events?
    return simplex->event[0]->x[axis] - simplex->event[0]->x[axis];
#endif
}

double relative_normal_velocity(const tf_simplex *point, const tf_simplex *edge,
                                const double normal[2])
{
    double velocity = 0;
    for (int k = 0; k < 2; k++)
#if defined TF_WRONG_2 // of the edge relative to the point
        velocity +=
            (displacement(edge, k) - displacement(point, k)) * normal[k];
#elif defined TF_WRONG_3 // as if the edge were at rest
        velocity += displacement(point, k) * normal[k];
#elif defined TF_SOLUTION || defined TF_WRONG_1
        velocity +=
            (displacement(point, k) - displacement(edge, k)) * normal[k];
#else
        // Your turn: of the point relative to the edge.
        velocity += displacement(point, k);
#endif
    return velocity;
}
