/* Exercise 6.1.  The normals of the three simplices of a sweep.
 *
 * Each of the three simplices of a triangle's sweep has four events.  Joining
 * the first event of each time to the others of that time yields two horizontal
 * edges: two at t = 0, or one at t = 0 and one at t = 1, or two at t = 1.  Find
 * the cross product of the first edge and the second, in the order of the
 * events.
 *
 * Section: Three normals.
 *
 * Hint 1: The events 0 to pivot are at t = 0, the others, pivot + 1 to 3, at
 *     t = 1.  A horizontal edge joins two events of the same group.
 * Hint 2: For pivot 2 the edges go from 0 to 1 and from 0 to 2, for pivot 1
 *     from 0 to 1 and from 2 to 3, for pivot 0 from 1 to 2 and from 1 to 3.
 * Hint 3: One loop is enough: let i run from 1 to 3 and skip pivot + 1.  The
 *     edge to event i starts at event 0 if i <= pivot, else at event pivot + 1.
 */
#include "geometry/sweep.h"

static void subtract(const tf_event *to, const tf_event *from, double edge[3])
{
    for (int k = 0; k < 3; k++)
        edge[k] = to->x[k] - from->x[k];
}

void simplex_normal(const tf_simplex *simplex, double normal[3])
{
    double e[2][3] = {{0}};
#if defined TF_SOLUTION
    int edges = 0;
    for (int i = 1; i < 4; i++) {
        if (i == simplex->pivot + 1)
            continue;
        int first = i <= simplex->pivot ? 0 : simplex->pivot + 1;
        subtract(simplex->event[i], simplex->event[first], e[edges++]);
    }
#elif defined TF_WRONG_1 // takes all edges from the first event
    subtract(simplex->event[1], simplex->event[0], e[0]);
    subtract(simplex->event[2], simplex->event[0], e[1]);
#elif defined TF_WRONG_2 // takes the two edges in reverse order
    int edges = 2;
    for (int i = 1; i < 4; i++) {
        if (i == simplex->pivot + 1)
            continue;
        int first = i <= simplex->pivot ? 0 : simplex->pivot + 1;
        subtract(simplex->event[i], simplex->event[first], e[--edges]);
    }
#elif defined TF_WRONG_3 // no mixed normal: takes the time with more events
    int first = simplex->pivot >= 1 ? 0 : 1;
    subtract(simplex->event[first + 1], simplex->event[first], e[0]);
    subtract(simplex->event[first + 2], simplex->event[first], e[1]);
#else
    // Your turn: find the two edges.
    subtract(simplex->event[0], simplex->event[0], e[0]);
    subtract(simplex->event[0], simplex->event[0], e[1]);
#endif
    for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3, last = (k + 2) % 3;
        normal[k] = e[0][next] * e[1][last] - e[0][last] * e[1][next];
    }
}
