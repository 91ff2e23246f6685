// Steps that are being resolved.
#include "geometry/step.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

static const double start[] = {3.3, 7, -1, 2}, proposed[] = {0.1, 8, 5, 5};
static double end[4];
static tf_step step = {
    .axes = 2, .vertices = 2, .start = start, .proposed = proposed, .end = end};

static void begin(void)
{
    memcpy(end, proposed, sizeof end);
}

START_TEST(displacements_in_the_plane_are_level)
{
    tf_vector d = tf_step_displacement(&step, 1, proposed);
    ck_assert_double_eq(d.x[0], 6);
    ck_assert_double_eq(d.x[1], 3);
    ck_assert_double_eq(d.x[2], 0);
}
END_TEST

// 3.3 + (0.1 - 3.3) is not 0.1 in doubles.
START_TEST(a_vertex_that_is_not_pushed_ends_at_the_base)
{
    begin();
    tf_vector d = tf_step_displacement(&step, 0, proposed);
    ck_assert_double_ne(start[0] + d.x[0], proposed[0]);
    tf_step_move(&step, 0, proposed, d.x, step.end);
    ck_assert_mem_eq(end, proposed, sizeof end);
}
END_TEST

// -0 + 0 is 0 in doubles.
START_TEST(a_vertex_that_is_not_pushed_keeps_the_sign_of_zero)
{
    static const double base[] = {-0., 8};
    begin();
    tf_vector d = tf_step_displacement(&step, 0, base);
    d.x[1] += 1;
    tf_step_move(&step, 0, base, d.x, step.end);
    ck_assert_mem_eq(end, base, sizeof *base);
    ck_assert_double_eq(end[1], 9);
}
END_TEST

START_TEST(a_pushed_vertex_ends_where_it_is_displaced)
{
    double d[] = {6, 4};
    begin();
    tf_step_move(&step, 1, proposed, d, step.end);
    ck_assert_double_eq(end[2], 5);
    ck_assert_double_eq(end[3], 6);
    ck_assert_mem_eq(end, proposed, 2 * sizeof *end);
}
END_TEST

START_TEST(a_vertex_stays_if_its_end_would_not_be_finite)
{
    static const double bad[][2] = {{INFINITY, 8}, {0.1, -INFINITY}, {NAN, 8}};
    begin();
    tf_step_move(&step, 0, proposed, bad[_i], step.end);
    ck_assert_mem_eq(end, proposed, sizeof end);
}
END_TEST

// No fraction of the longest way overflows, and both ends are exact.
START_TEST(a_part_of_a_way_is_between_its_ends)
{
    const double ends[] = {-1.7976931348623157e308, -1, -0., 0, 0x1p-1074, 1,
                           1.7976931348623157e308};
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 7; j++)
            for (int k = 0; k <= 8; k++) {
                double from = ends[i], to = ends[j], part = k / 8.;
                double x = tf_step_part(from, to, part);
                ck_assert(isfinite(x));
                if (k == 0 || from == to)
                    ck_assert_mem_eq(&x, &from, sizeof x);
                double half = from / 2 * (1 - part) + to / 2 * part;
                ck_assert_double_le(fabs(x / 2 - half),
                                    0x1p-51 * fmax(fabs(from), fabs(to)) +
                                        0x1p-1073);
            }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("geometry/step");
    TCase *tcase = tcase_create("ends");
    tcase_add_test(tcase, displacements_in_the_plane_are_level);
    tcase_add_test(tcase, a_vertex_that_is_not_pushed_ends_at_the_base);
    tcase_add_test(tcase, a_vertex_that_is_not_pushed_keeps_the_sign_of_zero);
    tcase_add_test(tcase, a_pushed_vertex_ends_where_it_is_displaced);
    tcase_add_test(tcase, a_part_of_a_way_is_between_its_ends);
    tcase_add_loop_test(tcase, a_vertex_stays_if_its_end_would_not_be_finite, 0,
                        3);
    suite_add_tcase(suite, tcase);
    return suite;
}
