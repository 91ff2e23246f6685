/* Exercise 4.3.  A contact for one instant, at a vertex.
 *
 * Find a point and an edge in the plane, moving or at rest, that meet in a
 * single instant, in mid-step (0 < t < 1), with the point at vertex 0 of the
 * edge.  The edge must have a length at t = 0 and at t = 1.
 *
 * Section: When signs are zero.
 *
 * Hint 1: Keep the edge at rest, and draw a line that touches it at vertex 0
 *     only.  The point may run along that line.
 * Hint 2: The line must not be that of the edge: on it the point would enter
 *     the edge at the vertex and then stay within it.
 * Hint 3: Any line across will do, say x = 0 for the edge from (0, 0) to (2,
 *     0).
 */
typedef struct encounter {
    double point[2][2];   // [time][axis]
    double edge[2][2][2]; // [vertex][time][axis]
} encounter;

encounter for_one_instant(void)
{
#if defined TF_SOLUTION
    return (encounter){.point = {{0, 1}, {0, -1}},
                       .edge = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_1 // along the line of the edge: enters and stays
    return (encounter){.point = {{-1, 0}, {1, 0}},
                       .edge = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_2 // one instant, but in the middle of the edge
    return (encounter){.point = {{1, 1}, {1, -1}},
                       .edge = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_3 // one instant, but the last of the step
    return (encounter){.point = {{0, 1}, {0, 0}},
                       .edge = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_4 // the edge is a point
    return (encounter){.point = {{0, 1}, {0, -1}},
                       .edge = {{{0, 0}, {0, 0}}, {{0, 0}, {0, 0}}}};
#elif defined TF_WRONG_5 // reaches vertex 0 and moves along with it
    return (encounter){.point = {{0, 1}, {0, 1}},
                       .edge = {{{0, 1}, {0, 1}}, {{2, 0}, {2, 0}}}};
#else
    // Your turn: here they do not meet.
    return (encounter){.point = {{0, 1}, {1, 2}},
                       .edge = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}};
#endif
}
