/* Exercise 5.1.  The normal of an edge.
 *
 * A triangle of an edge's sweep in the plane has one horizontal edge, between
 * its two events at the same time, whether that is t = 0 or t = 1.  Find the
 * unit normal of that edge: the direction from its first event to its second,
 * turned left by 90 degrees.  If the edge has no length the normal is zero.
 * (No length is so large or so small that its square is out of range.)
 *
 * Section: The normal, a determinant at a time.
 *
 * Hint 1: simplex->pivot + 1 events are at t = 0.  For an edge that is 2 or 1,
 *     and there are three events.  Which two share a time?
 * Hint 2: With pivot 1 they are the events 0 and 1, with pivot 0 the events 1
 *     and 2: event[1 - pivot] and event[2 - pivot].
 * Hint 3: The vector (x, y), turned left, is (-y, x).  Divide by the length
 *     unless that is zero.
 */
#include "geometry/sweep.h"

#include <math.h>

void edge_normal(const tf_simplex *simplex, double normal[2])
{
#if defined TF_SOLUTION
    const tf_event *from = simplex->event[1 - simplex->pivot];
    const tf_event *to = simplex->event[2 - simplex->pivot];
    double x = to->x[0] - from->x[0], y = to->x[1] - from->x[1];
    double length = hypot(x, y);
    normal[0] = length > 0 ? -y / length : 0;
    normal[1] = length > 0 ? x / length : 0;
#elif defined TF_WRONG_1 // takes the first two events: may mix the times
    const tf_event *from = simplex->event[0], *to = simplex->event[1];
    double x = to->x[0] - from->x[0], y = to->x[1] - from->x[1];
    double length = hypot(x, y);
    normal[0] = length > 0 ? -y / length : 0;
    normal[1] = length > 0 ? x / length : 0;
#elif defined TF_WRONG_2 // turns right
    const tf_event *from = simplex->event[1 - simplex->pivot];
    const tf_event *to = simplex->event[2 - simplex->pivot];
    double x = to->x[0] - from->x[0], y = to->x[1] - from->x[1];
    double length = hypot(x, y);
    normal[0] = length > 0 ? y / length : 0;
    normal[1] = length > 0 ? -x / length : 0;
#elif defined TF_WRONG_3 // divides by a length of zero
    const tf_event *from = simplex->event[1 - simplex->pivot];
    const tf_event *to = simplex->event[2 - simplex->pivot];
    double x = to->x[0] - from->x[0], y = to->x[1] - from->x[1];
    double length = hypot(x, y);
    normal[0] = -y / length;
    normal[1] = x / length;
#else
    // Your turn.
    normal[0] = normal[1] = 0;
#endif
}
