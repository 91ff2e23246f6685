/* Exercise 6.1.  Three normals.
 *
 * Each of the three simplices of a triangle's sweep has four events and two
 * horizontal edges, each between events of one time: two within t = 0, or one
 * within t = 0 and one within t = 1, or two within t = 1.  Find the cross
 * product of the first with the second, in the order of the events; two within
 * one time both start at the first event of that time.
 *
 * Section: Three normals.
 *
 * Hint 1: The events 0 to mover are at t = 0, the others, mover + 1 to 3, at
 *     t = 1.  Only pairs within one of the two groups make horizontal edges.
 * Hint 2: For mover 2 the edges are 0 to 1 and 0 to 2, for mover 1 they are 0
 *     to 1 and 2 to 3, for mover 0 they are 1 to 2 and 1 to 3.
 * Hint 3: In one loop: i runs from 1 to 3 and skips mover + 1; the edge goes to
 *     event i from event 0 if i <= mover, else from event mover + 1.
 */
#include "spacetime/sweep.h"

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
        if (i == simplex->mover + 1)
            continue;
        int first = i <= simplex->mover ? 0 : simplex->mover + 1;
        subtract(simplex->event[i], simplex->event[first], e[edges++]);
    }
#elif defined TF_WRONG_1 // always the start: from the first event
    subtract(simplex->event[1], simplex->event[0], e[0]);
    subtract(simplex->event[2], simplex->event[0], e[1]);
#elif defined TF_WRONG_2 // chains all events within a time, but backwards
    int edges = 2;
    for (int i = 1; i < 4; i++) {
        if (i == simplex->mover + 1)
            continue;
        int first = i <= simplex->mover ? 0 : simplex->mover + 1;
        subtract(simplex->event[i], simplex->event[first], e[--edges]);
    }
#elif defined TF_WRONG_3 // no mixed normal: takes the majority's time
    int first = simplex->mover >= 1 ? 0 : 1;
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
