// The nearest points of a surface, against trying each triangle.
#include "remesh/original.h"

#include "linear/distance.h"
#include "remesh/measure.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/collapse.h"

static double least_distance(const tf_adaptive_surface *surface, tf_vector x)
{
    double least = INFINITY;
    tf_vector corner[4] = {x};
    for (int t = 0; t < surface->triangles; t++) {
        tf_shape shape = tf_shape_of(surface, t);
        for (int i = 0; i < 3; i++)
            corner[i + 1] = shape.corner[i];
        least = fmin(least, tf_nearest_points(1, 3, corner).distance);
    }
    return least;
}

/// Expects that the point is where its weights say.
static void expect_point(const tf_adaptive_surface *surface,
                         const tf_projection *found)
{
    tf_shape shape = tf_shape_of(surface, found->origin.triangle);
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int i = 0; i < 3; i++)
            sum += found->origin.barycentric[i] * shape.corner[i].x[k];
        ck_assert_double_eq(sum, found->point.x[k]);
    }
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
        tf_vector x;
        for (int k = 0; k < 3; k++)
            x.x[k] = uniform(&run.random, -3, 3);
        tf_projection found = tf_original_project(&original, x);
        ck_assert_double_eq_tol(found.distance, least_distance(run.surface, x),
                                1e-12);
        tf_vector way = tf_vector_difference(found.point, x);
        ck_assert_double_eq_tol(tf_vector_length(way), found.distance, 1e-12);
        expect_point(run.surface, &found);
    }
    tf_original_free(&original);
    surgery_run_end(&run);
}
END_TEST

// Collapsed triangles are gaps.
START_TEST(gaps_do_not_count)
{
    tf_adaptive_surface *sheet = adaptive_sheet(3, 3);
    tf_outcome outcome;
    tf_original a = {0};
    ck_assert_int_eq(tf_adaptive_collapse(sheet, 5, 6, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_int_eq(tf_original_begin(&a, sheet, NULL), TF_OK);
    tf_projection found =
        tf_original_project(&a, (tf_vector){{1.25, 1.25, 0.5}});
    ck_assert(tf_is_triangle(sheet, found.origin.triangle));
    ck_assert_double_eq(found.distance, 0.5);
    tf_original_free(&a);
    tf_adaptive_free(sheet);
}
END_TEST

static bool never(void *context, const tf_stage *stage)
{
    (void)context, (void)stage;
    return false;
}

START_TEST(searches_can_be_cancelled)
{
    tf_adaptive_surface *sheet = adaptive_sheet(9, 9);
    tf_original a = {0};
    tf_watch own, *watch = tf_watch_begin(&own, never, NULL);
    ck_assert_int_eq(tf_original_begin(&a, sheet, watch), TF_CANCELLED);
    ck_assert_int_eq(tf_original_begin(&a, sheet, NULL), TF_OK);
    tf_original_free(&a);
    tf_adaptive_free(sheet);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/original");
    TCase *tcase = tcase_create("distances");
    tcase_add_loop_test(tcase, the_nearest_point_is_found, 0, ADAPTIVE_SCENES);
    tcase_add_test(tcase, gaps_do_not_count);
    tcase_add_test(tcase, searches_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}
