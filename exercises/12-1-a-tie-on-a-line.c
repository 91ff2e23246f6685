/* Exercise 12.1.  A tie on a line, broken by perturbation.
 *
 * Vertices lie on the x axis.  Each is moved slightly to the right, a vertex of
 * lower index infinitely more than one of higher index.  Of two moved vertices
 * with different indices, decide whether b is farther to the right than a
 * (positive) or to the left (negative).  There is no third answer, and all
 * answers together must be true of one row of vertices.
 *
 * Section: A tie, on a line.
 *
 * Hint 1: As long as the places are different, however close, the moves do not
 *     matter.
 * Hint 2: At the same place the lower index is farther right.
 * Hint 3: Compare the coordinates.  A tolerance, or a small number added to
 *     them, fails for places that are closer than that.
 */
#include "arithmetic/sign.h"
#include "geometry/event.h"

/// The coordinate is x[0], the index `vertex`.
tf_sign farther_right(const tf_event *a, const tf_event *b)
{
#if defined TF_SOLUTION
    if (a->x[0] != b->x[0])
        return a->x[0] < b->x[0] ? TF_POSITIVE : TF_NEGATIVE;
    return b->vertex < a->vertex ? TF_POSITIVE : TF_NEGATIVE;
#elif defined TF_WRONG_1 // moves by numbers that are not small enough
    double moved_a = a->x[0] + 1e-9 / (a->vertex + 1);
    double moved_b = b->x[0] + 1e-9 / (b->vertex + 1);
    return moved_a < moved_b ? TF_POSITIVE : TF_NEGATIVE;
#elif defined TF_WRONG_2 // the second argument wins a tie
    return a->x[0] <= b->x[0] ? TF_POSITIVE : TF_NEGATIVE;
#elif defined TF_WRONG_3 // moves vertices of higher index more
    if (a->x[0] != b->x[0])
        return a->x[0] < b->x[0] ? TF_POSITIVE : TF_NEGATIVE;
    return b->vertex > a->vertex ? TF_POSITIVE : TF_NEGATIVE;
#elif defined TF_WRONG_4 // truncates small distances to zero
    int distance = (int)(b->x[0] - a->x[0]);
    if (distance != 0)
        return distance > 0 ? TF_POSITIVE : TF_NEGATIVE;
    return b->vertex < a->vertex ? TF_POSITIVE : TF_NEGATIVE;
#else
    // Your turn: this is the sign for vertices that are not moved.
    return a->x[0] < b->x[0]   ? TF_POSITIVE
           : a->x[0] > b->x[0] ? TF_NEGATIVE
                               : TF_ZERO;
#endif
}
