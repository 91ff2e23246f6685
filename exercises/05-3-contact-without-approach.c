/* Exercise 5.3.  A contact with a normal velocity of zero.
 *
 * A point that runs along the line of an edge at rest meets it with a normal
 * velocity of zero.  Must the edge be at rest for that?  Find a point and an
 * edge in the plane that first meet in mid-step (0 < t < 1) such that
 * tf_point_edge reports a normal and a relative velocity that are not zero, but
 * a normal velocity that is.  And the edge must turn: it has a length at t = 0
 * and at t = 1, in directions that are not parallel.  Use whole numbers:
 * decimals like 0.1 are rounded, and the point runs along another line.
 *
 * Section: Relative and normal velocity.
 *
 * Hint 1: Velocity and normal are those of one triangle of the edge's sweep,
 *     and each triangle leaves out one event of the edge.  “The normal, a
 *     determinant at a time” shows which.
 * Hint 2: The triangle with pivot 1 does not have vertex 0 at t = 1.  So let
 *     the point run along the line of the edge at t = 0, keep vertex 1 at rest,
 *     and turn the edge by moving vertex 0.
 * Hint 3: Keep away from the crease, where either normal may be reported: the
 *     point must come to the side of that triangle that the other triangle does
 *     not share, that is, to vertex 1, which is at rest.
 */
typedef struct encounter {
    double point[2][2];   // [time][axis]
    double edge[2][2][2]; // [vertex][time][axis]
} encounter;

encounter contact_without_approach(void)
{
#if defined TF_SOLUTION
    return (encounter){.point = {{3, 0}, {1, 0}},
                       .edge = {{{0, 0}, {0, 2}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_1 // the edge rests
    return (encounter){.point = {{-1, 0}, {1, 0}},
                       .edge = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_2 // touches from the start
    return (encounter){.point = {{1, 0}, {3, 0}},
                       .edge = {{{0, 0}, {0, 2}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_3 // reaches the vertex that turns away
    return (encounter){.point = {{-1, 0}, {1, 0}},
                       .edge = {{{0, 0}, {0, 2}}, {{2, 0}, {2, 0}}}};
#elif defined TF_WRONG_4 // the relative velocity is zero
    return (encounter){.point = {{1, 0}, {1, 1}},
                       .edge = {{{0, 0}, {0, 2}}, {{2, 0}, {2, 1}}}};
#else
    // Your turn: here the point falls on an edge that turns.
    return (encounter){.point = {{1, 3}, {1, -1}},
                       .edge = {{{0, 0}, {0, 1}}, {{2, 0}, {2, 0}}}};
#endif
}
