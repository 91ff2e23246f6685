/* Exercise 6.3.  When is the normal of a contact zero?
 *
 * A triangle without area has no normal.  But even if a triangle has an area at
 * t = 0 and at t = 1, and a point meets it in mid-step, tf_point_triangle may
 * report a normal of zero.  Find such a point and such a triangle.
 *
 * Section: What the prism leaves out.
 *
 * Hint 1: The simplex with pivot 2 has the normal of the triangle at t = 0,
 *     and the simplex with pivot 0 has that of the triangle at t = 1.  So the
 *     point must meet the simplex with pivot 1.
 * Hint 2: Its normal is zero if the direction from vertex 1 to vertex 2 at
 *     t = 1 is the same as that from vertex 0 to vertex 1 at t = 0, or opposite
 *     to it.  Then this simplex is flat, and its neighbors cover most of it, so
 *     that the point meets them just as early.  Which worldline is in no other
 *     simplex?
 * Hint 3: That of vertex 1.  Let the point hit vertex 1 in mid-step, and choose
 *     the opposite direction, because with the same direction the neighbors
 *     cover all of the simplex.
 */
typedef struct encounter {
    double point[2][3];       // [time][axis]
    double triangle[3][2][3]; // [vertex][time][axis]
} encounter;

encounter no_normal(void)
{
#if defined TF_SOLUTION
    // Vertex 1 rests.  From 0 it is seen along +x, and from it 2 along -x.
    return (encounter){.point = {{1, 0, 1}, {1, 0, -1}},
                       .triangle = {{{0, 0, 0}, {0, 1, 0}},
                                    {{1, 0, 0}, {1, 0, 0}},
                                    {{0, 1, 0}, {0, 0, 0}}}};
#elif defined TF_WRONG_1 // no area at the start
    return (encounter){.point = {{1, 0, 1}, {1, 0, -1}},
                       .triangle = {{{0, 0, 0}, {0, 1, 0}},
                                    {{1, 0, 0}, {1, 0, 0}},
                                    {{2, 0, 0}, {0, 0, 0}}}};
#elif defined TF_WRONG_2 // a mixed normal that is not zero
    return (encounter){.point = {{1, 0, 1}, {1, 0, -1}},
                       .triangle = {{{0, 0, 0}, {0, 0, 0}},
                                    {{1, 0, 0}, {1, 0, 0}},
                                    {{0, 1, 0}, {0, 1, 0}}}};
#elif defined TF_WRONG_3 // intersects another simplex: vertex 0
    return (encounter){.point = {{0, 0.5, 1}, {0, 0.5, -1}},
                       .triangle = {{{0, 0, 0}, {0, 1, 0}},
                                    {{1, 0, 0}, {1, 0, 0}},
                                    {{0, 1, 0}, {0, 0, 0}}}};
#elif defined TF_WRONG_4 // touches at the start
    return (encounter){.point = {{1, 0, 0}, {1, 0, -1}},
                       .triangle = {{{0, 0, 0}, {0, 1, 0}},
                                    {{1, 0, 0}, {1, 0, 0}},
                                    {{0, 1, 0}, {0, 0, 0}}}};
#else
    // Your turn: here the point falls on a triangle at rest.
    return (encounter){.point = {{1, 1, 1}, {1, 1, -1}},
                       .triangle = {{{0, 0, 0}, {0, 0, 0}},
                                    {{4, 0, 0}, {4, 0, 0}},
                                    {{0, 4, 0}, {0, 4, 0}}}};
#endif
}
