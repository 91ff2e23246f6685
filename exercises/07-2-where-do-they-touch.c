/* Exercise 7.2.  Where do they touch?
 *
 * A contact tells its time and the weights of the vertices, but not the place.
 * Find it: the point of a moving edge that has the weights weight[0] and
 * weight[1], both >= 0 with the sum 1, at the time t.  Remember that the
 * vertices take turns!
 *
 * Section: A query by hand.
 *
 * Hint 1: The share of the late events, those at t = 1, is t.  Vertex 1 pulls
 *     first: its weight goes over from its early to its late event until all of
 *     it is late, and only then does that of vertex 0.
 * Hint 2: So of the weight of vertex 1 the smaller of t and weight[1] is late.
 *     What is left of t is the late part of vertex 0.
 * Hint 3: The place is the sum over both vertices of late times at[1] and of
 *     weight - late times at[0].
 */
#include "spacetime/event.h"

#include <math.h>

void place_on_edge(const tf_worldline edge[2], const double weight[2], double t,
                   double place[3])
{
    double late[2]; // how much of each weight is on the event at t = 1
#if defined TF_SOLUTION
    late[1] = fmin(t, weight[1]);
    late[0] = t - late[1];
#elif defined TF_WRONG_1 // pulls all the time, as in linear motion
    late[1] = t * weight[1];
    late[0] = t * weight[0];
#elif defined TF_WRONG_2 // lets vertex 0 pull first
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
