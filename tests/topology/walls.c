// Surgery on a ball: a square that goes, and the four sides of a pyramid that
// come.
#include "topology/walls.h"

#include "experiments/leave_out.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/surgery.h"
#include "topology/stage.h"

enum {
    SPECK = 4 ///< its first vertex
};

/// A unit square that looks up, and a speck somewhere.
static tf_adaptive_surface *square_and_speck(double x, double y, double z)
{
    static double position[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3, 4, 6, 5,
                                   4, 5, 7, 5, 6, 7, 6, 4, 7};
    for (int i = 0; i < 12; i++) {
        const double at[] = {x, y, z};
        position[SPECK + i / 3][i % 3] =
            at[i % 3] + (i / 3 == i % 3 + 1 ? 0.01 : 0);
    }
    return adaptive_of(8, position, 6, triangle);
}

/// Tries to replace the square by a pyramid, upwards or downwards.
static tf_outcome try_pyramid(tf_adaptive_surface *surface, double height)
{
    const double tip[] = {0.5, 0.4, height}, far[] = {-9, 0.5, 90};
    tf_walls walls = {0};
    ck_assert(tf_surgery_begin(surface, 8));
    int top = tf_surgery_place(surface, tip);
    int roof = tf_surgery_place(surface, far);
    tf_surgery_add(surface, 1, 2, roof); // in an earlier stage
    tf_surgery_end_stage(surface);
    for (int t = 0; t < 2; t++) {
        const int *v = tf_triangle(surface, t);
        tf_surgery_remove(surface, t);
        tf_walls_add(&walls, surface, v[0], v[1], v[2]);
    }
    for (int i = 0; i < 4; i++)
        tf_surgery_add(surface, i, (i + 1) % 4, top);
    return tf_walls_try(&walls, surface);
}

START_TEST(a_ball_that_holds_a_vertex_is_refused)
{
    static const struct {
        double x, y, z, height;
        tf_outcome expected;
    } row[] = {
        {0.5, 0.4, 0.5, 1, TF_PASSED_VERTEX}, // inside
        {0.5, 0.4, 0.9, 1, TF_PASSED_VERTEX}, //
        {0.5, 0.4, 0.5, 0.4, TF_COMMITTED},   // above
        {0.1, 0.1, 0.5, 1, TF_COMMITTED},     // beside, but in the box
        {0.5, 0.4, -0.5, 1, TF_COMMITTED},    // below
        {0.5, 0.4, -0.5, -1, TF_PASSED_VERTEX},
        {0.1, 0.1, -0.9, -1, TF_COMMITTED},   // below a side
        {0.25, 0.2, 0.498, 1, TF_OVERLAPPED}, // on a side
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        tf_adaptive_surface *surface =
            square_and_speck(row[i].x, row[i].y, row[i].z);
        ck_assert_int_eq(try_pyramid(surface, row[i].height), row[i].expected);
        if (row[i].expected == TF_PASSED_VERTEX) {
            leave_out(1U << TF_PASSED_VERTEX);
            ck_assert_int_eq(try_pyramid(surface, row[i].height), TF_COMMITTED);
            leave_out(0);
        }
        tf_adaptive_free(surface);
    }
}
END_TEST

START_TEST(triangles_on_walls_are_refused)
{
    tf_adaptive_surface *surface = square_and_speck(9, 9, 9);
    ck_assert_int_eq(try_pyramid(surface, 0), TF_OVERLAPPED);
    leave_out(1U << TF_OVERLAPPED);
    ck_assert_int_eq(try_pyramid(surface, 0), TF_COMMITTED);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/walls");
    TCase *tcase = tcase_create("balls");
    tcase_add_test(tcase, a_ball_that_holds_a_vertex_is_refused);
    tcase_add_test(tcase, triangles_on_walls_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
