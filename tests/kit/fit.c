#include "kit/fit.h"
#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    POINTS = 8
};

/// Expect points in the box, in the order in which they were on each axis, and
/// each span that is filled, filled.
static void expect_fitted(int axes, const tf_vector before[POINTS])
{
    tf_vector after[POINTS];
    memcpy(after, before, sizeof after);
    fig_fit fit = fig_fit_points(axes, POINTS, after);
    for (int k = 0; k < 3; k++) {
        double lo = 1, hi = -1;
        for (int i = 0; i < POINTS; i++) {
            lo = fmin(lo, after[i].x[k]);
            hi = fmax(hi, after[i].x[k]);
            ck_assert_msg(fabs(after[i].x[k]) <= 0.5 + 1e-15,
                          "axis %d: %a became %a", k, before[i].x[k],
                          after[i].x[k]);
            for (int j = 0; j < i && k < axes; j++)
                ck_assert(before[i].x[k] <= before[j].x[k]
                              ? after[i].x[k] <= after[j].x[k]
                              : after[i].x[k] >= after[j].x[k]);
        }
        bool filled = k < axes && fit.span[k].fraction > 0;
        if (!filled)
            ck_assert(lo == 0 && hi == 0);
        else if (!fit.alike)
            ck_assert_double_eq_tol(hi - lo, 1, 1e-15);
    }
}

START_TEST(lengths_are_kept_where_axes_are_alike)
{
    tf_vector point[3] = {{{1, 2, 7}}, {{3, 2, 7}}, {{1, 6, 7}}};
    fig_fit fit = fig_fit_points(3, 3, point);
    static const tf_vector right[3] = {
        {{-0.25, -0.5, 0}}, {{0.25, -0.5, 0}}, {{-0.25, 0.5, 0}}};
    ck_assert(fit.alike);
    ck_assert_mem_eq(point, right, sizeof right);
}
END_TEST

START_TEST(axes_of_other_scales_fill_the_box)
{
    tf_vector point[2] = {{{0, 1e300, -5e-324}}, {{1, -1e300, 5e-324}}};
    fig_fit fit = fig_fit_points(3, 2, point);
    static const tf_vector right[2] = {{{-0.5, 0.5, -0.5}}, {{0.5, -0.5, 0.5}}};
    ck_assert(!fit.alike);
    ck_assert_mem_eq(point, right, sizeof right);
}
END_TEST

START_TEST(extreme_points_fit)
{
    generator random = generator_new(1);
    static const double some[] = {0,       DBL_MAX,     -DBL_MAX, 5e-324,
                                  -5e-324, DBL_MIN,     -DBL_MIN, 1,
                                  -1,      1 + 0x1p-52, 0x1p1000, 0x1p-1000};
    for (long n = cases(20000); n > 0; n--) {
        tf_vector point[POINTS];
        int kinds = 1 + below(&random, sizeof some / sizeof *some);
        for (int i = 0; i < POINTS; i++)
            for (int k = 0; k < 3; k++)
                point[i].x[k] = some[below(&random, kinds)];
        expect_fitted(2 + below(&random, 2), point);
    }
}
END_TEST

START_TEST(numbers_are_written_for_readers)
{
    static const struct {
        double number;
        const char *text;
        bool whole;
    } right[] = {{0, "0", true},
                 {3, "3", true},
                 {-0.25, "-0.25", true},
                 {2.0 / 3, "0.6667", false},
                 {1500, "1500", true},
                 {12345, "1.2×10^{4}", false},
                 {-2e24, "-2.0×10^{24}", false},
                 {9.99e99, "1.0×10^{100}", false},
                 {5e-324, "4.9×10^{-324}", false},
                 {DBL_MAX, "1.8×10^{308}", false}};
    for (size_t i = 0; i < sizeof right / sizeof *right; i++) {
        char text[FIG_NUMBER_TEXT];
        ck_assert_int_eq(fig_number_text(right[i].number, text),
                         right[i].whole);
        ck_assert_str_eq(text, right[i].text);
    }
    char text[FIG_NUMBER_TEXT];
    fig_span_text((fig_span){0.5, 2000}, text);
    ck_assert_str_eq(text, "5.7×10^{601}");
}
END_TEST

START_TEST(axes_can_be_kept_alike)
{
    tf_vector point[2] = {{{0, 1e300, 2}}, {{1, -1e300, 2}}};
    fig_fit fit = fig_fit_points_alike(3, 2, point);
    ck_assert(fit.alike);
    for (int i = 0; i < 2; i++) {
        ck_assert_double_eq_tol(point[i].x[0], 0, 1e-299);
        ck_assert_double_eq(point[i].x[1], i ? -0.5 : 0.5);
        ck_assert_double_eq(point[i].x[2], 0);
    }
}
END_TEST

START_TEST(times_tell_whether_they_are_rounded)
{
    char text[FIG_TIME_TEXT];
    fig_time_text(0.5, text);
    ck_assert_str_eq(text, "$t = 0.5$");
    fig_time_text(1.0 / 3, text);
    ck_assert_str_eq(text, "$t ≈ 0.3333$");
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("kit/fit");
    TCase *fit = tcase_create("fit");
    tcase_add_test(fit, lengths_are_kept_where_axes_are_alike);
    tcase_add_test(fit, axes_of_other_scales_fill_the_box);
    tcase_add_test(fit, extreme_points_fit);
    tcase_add_test(fit, axes_can_be_kept_alike);
    tcase_add_test(fit, numbers_are_written_for_readers);
    tcase_add_test(fit, times_tell_whether_they_are_rounded);
    suite_add_tcase(s, fit);
    return s;
}
