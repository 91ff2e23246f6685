/* Exercise 7.2.  The position of a contact.
 *
 * A contact has a time and barycentric coordinates, but no place.  Find it: the
 * place at time t of the point of a moving edge that has the barycentric
 * coordinates weight[0] and weight[1], not negative and with the sum 1.
 * Remember that the vertices take turns!
 *
 * Section: A query by hand.
 *
 * Hint 1: At time t, the coordinates of the events at t = 1 sum to t.  Vertex 1
 *     goes first: its coordinate passes from its start event to its end event,
 *     and once nothing of it is left, that of vertex 0 follows.
 * Hint 2: So the end event of vertex 1 has the smaller of t and weight[1], and
 *     the end event of vertex 0 has what is left of t.
 * Hint 3: The place is a sum over both vertices: the coordinate of the end
 *     event times at[1], plus the rest of the vertex's coordinate times at[0].
 */
#include "geometry/event.h"

#include <math.h>

void place_on_edge(const tf_worldline edge[2], const double weight[2], double t,
                   double place[3])
{
    double late[2]; // how much of each coordinate is at t = 1
#if defined TF_SOLUTION
    late[1] = fmin(t, weight[1]);
    late[0] = t - late[1];
#elif defined TF_WRONG_1 // all vertices move all the time, as in linear motion
    late[1] = t * weight[1];
    late[0] = t * weight[0];
#elif defined TF_WRONG_2 // lets vertex 0 go first
    late[0] = fmin(t, weight[0]);
    late[1] = t - late[0];
#elif defined TF_WRONG_3 // moves one vertex only
    late[1] = fmin(t, weight[1]);
    late[0] = 0;
#else
    // Your turn: nothing moves yet.
    late[0] = late[1] = fmin(t, 0);
#endif
    for (int k = 0; k < 3; k++) {
        place[k] = 0;
        for (int v = 0; v < 2; v++)
            place[k] += (weight[v] - late[v]) * edge[v].at[0].x[k] +
                        late[v] * edge[v].at[1].x[k];
    }
}
