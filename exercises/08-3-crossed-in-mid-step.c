/* Exercise 8.3.  Triangles that cross in mid-step without a contact.
 *
 * If no point meets a triangle and no edge meets an edge, then triangles that
 * do not intersect at the start do not intersect at the end.  In between they
 * may!  Find two moving triangles that do not intersect at t = 0, with no
 * contact of a point with a triangle or of an edge with an edge in the whole
 * step, which cross in mid-step; and a time t, 0 < t < 1, at which they do.
 *
 * Such steps are hard to imagine.  Your function may find its answer by a search
 * that takes a second or two, or you may search elsewhere and only put the answer
 * here.
 *
 * Section: What the theorems do not promise.
 *
 * Hint 1: In mid-step a triangle is bent at up to two creases, and a crease is
 *     not an edge: no query checks whether it crosses the crease of another
 *     triangle.  Bend both triangles a lot, that is, let their vertices move
 *     differently.
 * Hint 2: Let the computer search.  Take coordinates at random, from -1 to 1 at
 *     t = 0, and for t = 1 add random displacements of up to 1.  Of the steps
 *     that start clear and have no contact, a few in a thousand will do.
 * Hint 3: To find out whether two triangles cross at time t, cut the sweeps:
 *     where event i at the start and event j at the end are both in a simplex,
 *     its slice has the corner (1 - t) start + t end.  Two slices are
 *     triangles, one is a parallelogram.  They cross if an edge of one slice
 *     crosses a triangle of the other: tf_complementary_intersect, of
 *     intersect/complementary.h, decides that for a pair at one time.
 */
typedef struct crossing {
    double triangle[2][3][2][3]; // [triangle][vertex][time][axis]
    double t;
} crossing;

crossing crossed_in_mid_step(void)
{
#if defined TF_SOLUTION
    // Found by a search as in hint 2, with displacements of up to 0.3.
    return (crossing){{{{{-0.872, 0.676, 0.823}, {-0.946, 0.844, 1.005}},
                        {{0.713, -0.982, -0.792}, {0.656, -1.159, -1.030}},
                        {{-0.490, -0.936, -0.491}, {-0.268, -0.777, -0.223}}},
                       {{{-0.615, 0.064, 0.312}, {-0.580, -0.087, 0.384}},
                        {{0.441, 0.554, 0.489}, {0.163, 0.361, 0.330}},
                        {{0.673, -0.944, -0.039}, {0.940, -0.787, -0.074}}}},
                      .t = 0.1};
#elif defined TF_WRONG_1 // crosses at the start
    return (crossing){{{{{-1, -1, 0}, {-1, -1, 0}},
                        {{2, -1, 0}, {2, -1, 0}},
                        {{-1, 2, 0}, {-1, 2, 0}}},
                       {{{0, 0, -1}, {0, 0, -1}},
                        {{0, 0, 1}, {0, 0, 1}},
                        {{5, 5, 0}, {5, 5, 0}}}},
                      .t = 0.5};
#elif defined TF_WRONG_2 // a point goes through a triangle and comes out again
    return (crossing){{{{{-1, -1, 0}, {-1, -1, 0}},
                        {{2, -1, 0}, {2, -1, 0}},
                        {{-1, 2, 0}, {-1, 2, 0}}},
                       {{{0, 0, 1}, {0, 0, -1}},
                        {{0, 1, 3}, {0, 1, 3}},
                        {{1, 0, 3}, {1, 0, 3}}}},
                      .t = 0.75};
#elif defined TF_WRONG_3 // no contact, and no crossing either
    return (crossing){{{{{-1, -1, 0}, {-1, -1, 0}},
                        {{2, -1, 0}, {2, -1, 0}},
                        {{-1, 2, 0}, {-1, 2, 0}}},
                       {{{0, 0, 2}, {0, 0, 1}},
                        {{0, 1, 3}, {0, 1, 3}},
                        {{1, 0, 3}, {1, 0, 3}}}},
                      .t = 0.5};
#elif defined TF_WRONG_4 // they cross, but not at this time
    return (crossing){{{{{-0.872, 0.676, 0.823}, {-0.946, 0.844, 1.005}},
                        {{0.713, -0.982, -0.792}, {0.656, -1.159, -1.030}},
                        {{-0.490, -0.936, -0.491}, {-0.268, -0.777, -0.223}}},
                       {{{-0.615, 0.064, 0.312}, {-0.580, -0.087, 0.384}},
                        {{0.441, 0.554, 0.489}, {0.163, 0.361, 0.330}},
                        {{0.673, -0.944, -0.039}, {0.940, -0.787, -0.074}}}},
                      .t = 0.9};
#else
    // Your turn: here everything is at the origin.
    return (crossing){.t = 0.5};
#endif
}
