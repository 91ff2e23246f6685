// What an untangling has done, measured.
#include "untangle/measures.h"

#include "support/support.h"
#include "support/tangles.h"

#include <math.h>
#include <string.h>

static made_tangle own;
static double x[3 * TANGLE_VERTICES];
static tf_untangle_report report;

static void add_tetrahedron(bool open)
{
    int first =
        tangle_add(&own, 4, (double[]){0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0, 2});
    tangle_add_triangle(&own, first, first + 2, first + 1);
    tangle_add_triangle(&own, first, first + 1, first + 3);
    tangle_add_triangle(&own, first + 1, first + 2, first + 3);
    if (!open)
        tangle_add_triangle(&own, first, first + 3, first + 2);
}

static void finish(void)
{
    tangle_finish(&own);
    memcpy(x, own.x, sizeof x);
}

static void measure(int power)
{
    report = (tf_untangle_report){.found = 7};
    ck_assert(tf_measure(&own.tangle, x, power, &report));
    ck_assert_double_eq(report.found, 7);
}

START_TEST(what_has_not_moved_measures_nothing)
{
    tangle_begin(&own, 3);
    add_tetrahedron(false);
    finish();
    measure(0);
    ck_assert_int_eq(report.moved, 0);
    ck_assert_double_eq(report.farthest, 0);
    ck_assert_double_eq(report.mean, 0);
    ck_assert_double_eq(report.deviation, 0);
    ck_assert_int_eq(report.stretched, 0);
    ck_assert_double_eq(report.stretch, 1);
    ck_assert_double_eq(report.volume_before, 3);
    ck_assert_double_eq(report.volume_after, 3);
    ck_assert_int_eq(report.turned, 0);
    tangle_free(&own);
}
END_TEST

START_TEST(ways_are_measured)
{
    tangle_begin(&own, 3);
    add_tetrahedron(false);
    finish();
    x[3] += 3;
    x[4] += 4;
    x[11] += 1;
    measure(0);
    ck_assert_int_eq(report.moved, 2);
    ck_assert_double_eq(report.farthest, 5);
    ck_assert_double_eq(report.mean, 3);
    ck_assert_double_eq(report.deviation, sqrt(26 / 4.0));
    ck_assert_double_eq(report.deviation, tf_deviation(&own.tangle, x));
    tangle_free(&own);
}
END_TEST

START_TEST(edges_stretch_by_ratios)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 4, (double[]){0, 0, 0, 2, 0, 0, 9, 0, 0, 9, 4, 0});
    tangle_add_edge(&own, 0, 1);
    tangle_add_edge(&own, 2, 3);
    finish();
    x[3] = 3; // 1.5, no more
    measure(0);
    ck_assert_int_eq(report.stretched, 0);
    ck_assert_double_eq(report.stretch, 1.5);
    ck_assert_double_eq(report.edge, 3);
    x[10] = 1; // a quarter
    measure(0);
    ck_assert_int_eq(report.stretched, 1);
    ck_assert_double_eq(report.stretch, 4);
    tangle_free(&own);
}
END_TEST

START_TEST(open_sheets_have_no_volume)
{
    tangle_begin(&own, 3);
    add_tetrahedron(true);
    finish();
    measure(0);
    ck_assert_double_eq(report.volume_before, 0);
    tangle_free(&own);
}
END_TEST

START_TEST(what_turns_inside_out_is_counted)
{
    tangle_begin(&own, 3);
    add_tetrahedron(false);
    add_tetrahedron(false);
    finish();
    for (int v = 0; v < 4; v++)
        x[3 * v + 2] = -x[3 * v + 2];
    measure(0);
    ck_assert_double_eq(report.volume_before, 6);
    ck_assert_double_eq(report.volume_after, 0);
    ck_assert_int_eq(report.turned, 1);
    tangle_free(&own);
}
END_TEST

START_TEST(measures_are_scaled_back)
{
    tangle_begin(&own, 3);
    add_tetrahedron(false);
    finish();
    x[11] += 1;
    measure(4);
    ck_assert_double_eq(report.farthest, 16);
    ck_assert_double_eq(report.volume_before, 3 * 4096.0);
    tangle_free(&own);
}
END_TEST

START_TEST(areas_in_the_plane)
{
    tangle_begin(&own, 2);
    tangle_add(&own, 4, (double[]){0, 0, 2, 0, 2, 3, 0, 3});
    for (int j = 0; j < 4; j++)
        tangle_add_edge(&own, j, (j + 1) % 4);
    finish();
    x[5] = 5;
    measure(1);
    ck_assert_double_eq(report.volume_before, 4 * 6);
    ck_assert_double_eq(report.volume_after, 4 * 8);
    tangle_free(&own);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/measures");
    TCase *tcase = tcase_create("measures");
    tcase_add_test(tcase, what_has_not_moved_measures_nothing);
    tcase_add_test(tcase, ways_are_measured);
    tcase_add_test(tcase, edges_stretch_by_ratios);
    tcase_add_test(tcase, open_sheets_have_no_volume);
    tcase_add_test(tcase, what_turns_inside_out_is_counted);
    tcase_add_test(tcase, measures_are_scaled_back);
    tcase_add_test(tcase, areas_in_the_plane);
    suite_add_tcase(suite, tcase);
    return suite;
}
