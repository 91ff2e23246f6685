/* Exercise 1.3.  An edge that hits in one order of its vertices only.
 *
 * Neighboring elements share an edge, and its sweep must be the same for both.
 * That is why vertices are taken in the order of their indices.  What goes
 * wrong otherwise?  Find a point at rest and a moving edge in the plane such
 * that the edge hits the point when its vertices are taken in the order 0, 1
 * and misses it when they are taken in the order 1, 0.
 *
 * Your function returns the position of the point and, for vertices 0 and 1,
 * the positions at t = 0 and t = 1.
 *
 * Section: The order is part of the answer.
 *
 * Hint 1: For a point at rest only the place matters, not the time.  So look at
 *     space-time from above, along the axis of time: what do the two triangles
 *     of the sweep cover?
 * Hint 2: In the order 0, 1 they cover the triangles e0 e1 e1' and e0 e0' e1',
 *     where e0 and e1 are the vertices at t = 0, e0' and e1' at t = 1.  In the
 *     other order they cover e1 e0 e0' and e1 e1' e0'.
 * Hint 3: These are the two ways to cut the quadrilateral e0 e1 e1' e0' along a
 *     diagonal.  Where it is convex both cover the same.  So take one with a
 *     notch: one of its diagonals runs outside.
 */
#include "geometry/event.h"

typedef struct encounter {
    double point[2];
    double edge[2][2][2]; // [vertex][time][axis]
} encounter;

encounter between_two_orders(void)
{
#if defined TF_SOLUTION
    // The quadrilateral (0,0), (4,0), (1,1), (0,4) has its notch at (1,1).
    return (encounter){.point = {1.5, 1.5},
                       .edge = {{{4, 0}, {0, 0}}, {{1, 1}, {0, 4}}}};
#elif defined TF_WRONG_1 // convex: the point is hit in both orders
    return (encounter){.point = {1, 1},
                       .edge = {{{0, 0}, {0, 3}}, {{3, 0}, {3, 3}}}};
#elif defined TF_WRONG_2 // in the notch, but outside either order's sweep
    return (encounter){.point = {3, 3},
                       .edge = {{{4, 0}, {0, 0}}, {{1, 1}, {0, 4}}}};
#elif defined TF_WRONG_3 // the orders are exchanged
    return (encounter){.point = {1.5, 1.5},
                       .edge = {{{1, 1}, {0, 4}}, {{4, 0}, {0, 0}}}};
#else
    // Your turn: here nothing moves and nothing is hit.
    return (encounter){.point = {0, 1},
                       .edge = {{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}}};
#endif
}
