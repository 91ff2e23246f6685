// What is measured of triangles.
#include "remesh/measure.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/move.h"

START_TEST(edges_have_lengths_and_middles)
{
    tf_adaptive_surface *sheet = adaptive_sheet(3, 4);
    ck_assert_double_eq(tf_length_of(sheet, 0, 19), 5);
    tf_vector middle = tf_middle_of(sheet, 1, 6);
    ck_assert_double_eq(middle.x[0], 1.5);
    ck_assert_double_eq(middle.x[1], 0.5);
    ck_assert_double_eq(middle.x[2], 0);
    tf_adaptive_free(sheet);
}
END_TEST

START_TEST(triangles_have_normals)
{
    tf_adaptive_surface *sheet = adaptive_sheet(1, 1);
    tf_shape shape = tf_shape_of(sheet, 0);
    tf_vector normal = tf_shape_normal(&shape);
    ck_assert_double_eq(normal.x[0], 0);
    ck_assert_double_eq(normal.x[1], 0);
    ck_assert_double_eq(normal.x[2], 1);
    tf_vector other = {{0, 3, 3}};
    ck_assert(tf_normals_agree(normal, other, 0.707));
    ck_assert(!tf_normals_agree(normal, other, 0.708));
    tf_adaptive_free(sheet);
}
END_TEST

START_TEST(stars_get_no_worse)
{
    static const struct {
        tf_vector position;
        bool good;
    } rows[] = {{{{1, 1, 0}}, true},
                {{{1.1, 1.1, 0}}, true},
                {{{1.9, 1, 0}}, false},  // thin
                {{{1, 1, 0.9}}, false},  // bent
                {{{1, 2.5, 0}}, false}}; // turned over
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    for (int i = 0; i < 5; i++)
        ck_assert(tf_star_stays_good(sheet, 4, TF_NONE, rows[i].position) ==
                  rows[i].good);
    // The triangles at 8 would be turned over, but they vanish.
    tf_vector at_8 = {{2, 2, 0}};
    ck_assert(!tf_star_stays_good(sheet, 4, TF_NONE, at_8));
    ck_assert(!tf_star_stays_good(sheet, 4, 8, at_8));
    tf_vector beyond = {{1.1, 1.1, 0}};
    ck_assert(tf_star_stays_good(sheet, 4, 8, beyond));
    tf_adaptive_free(sheet);
}
END_TEST

START_TEST(quality_is_from_0_to_1)
{
    static const struct {
        tf_shape shape;
        double quality;
    } rows[] = {
        {{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}, 1},
        {{{{{0, 0, 0}}, {{7, 0, 0}}, {{0, 7, 0}}}}, 0.8660254},
        {{{{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}}}, 0},
        {{{{{0, 0, 0}}, {{1, 0, 0}}, {{0.5, 0.01, 0}}}}, 0.02309093},
    };
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(tf_shape_quality(&rows[i].shape),
                                rows[i].quality, 1e-7);
    const tf_shape pair[] = {rows[0].shape, rows[3].shape};
    ck_assert_double_eq_tol(tf_worse_quality(pair), rows[3].quality, 1e-7);
}
END_TEST

/// Expects that a surface with a vertex at that height is refused, or not.
static void expect_measurable(double height, tf_status expected)
{
    tf_adaptive_surface *sheet = adaptive_sheet(1, 1);
    const double far[] = {0, 0, height};
    tf_outcome outcome;
    tf_error error;
    ck_assert_int_eq(tf_adaptive_move(sheet, 0, far, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_int_eq(tf_check_coordinates(sheet, TF_MOST_FOR_VOLUMES, &error),
                     expected);
    ck_assert_int_eq(error.status, expected);
    ck_assert_int_eq(error.vertex[0], expected == TF_OK ? -1 : 0);
    tf_adaptive_free(sheet);
}

START_TEST(coordinates_can_be_measured_or_not)
{
    expect_measurable(0x1p250, TF_OK);
    expect_measurable(-0x1p250, TF_OK);
    expect_measurable(nextafter(0x1p250, INFINITY), TF_OUT_OF_RANGE);
    expect_measurable(-0x1p1000, TF_OUT_OF_RANGE);
}
END_TEST

START_TEST(vertices_without_triangles_may_be_anywhere)
{
    static const int triangle[] = {0, 1, 2};
    static const double position[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1e300, 0, 0};
    const tf_mesh mesh = {
        .axes = 3, .vertices = 4, .triangles = 1, .triangle = triangle};
    tf_adaptive_surface *made;
    ck_assert_int_eq(tf_adaptive_create(&mesh, position, &made, NULL), TF_OK);
    ck_assert_int_eq(tf_check_coordinates(made, TF_MOST_FOR_VOLUMES, NULL),
                     TF_OK);
    tf_adaptive_free(made);
}
END_TEST

START_TEST(targets_are_lengths_that_lead_to_few_triangles)
{
    static const double bad[] = {0, -1, NAN, INFINITY, 1e-5, 0x1p-1074};
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    tf_error error;
    ck_assert_int_eq(tf_check_target(sheet, 2e-4, &error), TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    for (int i = 0; i < (int)(sizeof bad / sizeof *bad); i++) {
        ck_assert_int_eq(tf_check_target(sheet, bad[i], &error), TF_BAD_OPTION);
        ck_assert_str_eq(error.option, "edge");
    }
    tf_adaptive_free(sheet);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/measure");
    TCase *tcase = tcase_create("measures");
    tcase_add_test(tcase, edges_have_lengths_and_middles);
    tcase_add_test(tcase, triangles_have_normals);
    tcase_add_test(tcase, quality_is_from_0_to_1);
    tcase_add_test(tcase, stars_get_no_worse);
    tcase_add_test(tcase, coordinates_can_be_measured_or_not);
    tcase_add_test(tcase, vertices_without_triangles_may_be_anywhere);
    tcase_add_test(tcase, targets_are_lengths_that_lead_to_few_triangles);
    suite_add_tcase(suite, tcase);
    return suite;
}
