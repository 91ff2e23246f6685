// The nearest points of a surface, against trying each triangle.
#include "remesh/original.h"

#include "linear/distance.h"
#include "remesh/measure.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"

static double least_distance(const tf_adaptive_surface *surface,
                             const double x[3])
{
    double least = INFINITY;
    tf_vector corner[4] = {{{x[0], x[1], x[2]}}};
    for (int t = 0; t < surface->triangles; t++) {
        tf_shape shape = tf_shape_of(surface, t);
        for (int i = 0; i < 3; i++)
            corner[i + 1] = shape.corner[i];
        least = fmin(least, tf_nearest_points(1, 3, corner).distance);
    }
    return least;
}

START_TEST(the_nearest_point_is_found)
{
    static surgery_run run;
    static surgery_counts counts;
    tf_original original = {0};
    surgery_run_begin(&run, generator_new((uint64_t)_i),
                      (adaptive_scene_kind)_i, &counts);
    ck_assert_int_eq(tf_original_begin(&original, run.surface, NULL), TF_OK);
    for (long i = 0; i < cases(300); i++) {
        double x[3], point[3];
        for (int k = 0; k < 3; k++)
            x[k] = uniform(&run.random, -3, 3);
        double distance = tf_original_nearest(&original, x, point);
        ck_assert_double_eq_tol(distance, least_distance(run.surface, x),
                                1e-12);
        tf_vector way = {{point[0] - x[0], point[1] - x[1], point[2] - x[2]}};
        ck_assert_double_eq_tol(tf_vector_length(way), distance, 1e-12);
    }
    tf_original_free(&original);
    surgery_run_end(&run);
}
END_TEST

START_TEST(the_distance_is_that_of_the_farthest)
{
    static double position[][3] = {{0, 0, 0.5}, {3, 0, 0}, {0, 3, 0}};
    static const int triangle[] = {0, 1, 2};
    tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
    tf_adaptive_surface *other = adaptive_of(3, position, 1, triangle);
    tf_original a = {0}, b = {0};
    ck_assert_int_eq(tf_original_begin(&a, sheet, NULL), TF_OK);
    ck_assert_int_eq(tf_original_begin(&b, other, NULL), TF_OK);
    ck_assert_double_eq(tf_original_farthest(&a, other, NULL), 0.5);
    ck_assert_double_eq_tol(tf_original_farthest(&b, sheet, NULL), sqrt(4.5),
                            1e-12);
    ck_assert_double_eq_tol(tf_original_farthest(&a, sheet, NULL), 0, 1e-15);
    tf_original_free(&a);
    tf_original_free(&b);
    tf_adaptive_free(sheet);
    tf_adaptive_free(other);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/original");
    TCase *tcase = tcase_create("distances");
    tcase_add_loop_test(tcase, the_nearest_point_is_found, 0, ADAPTIVE_SCENES);
    tcase_add_test(tcase, the_distance_is_that_of_the_farthest);
    suite_add_tcase(suite, tcase);
    return suite;
}
