#include "response/choices.h"

#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <limits.h>
#include <math.h>

START_TEST(options_out_of_range_are_named)
{
    static const struct {
        tf_response_options options;
        const char *option;
    } bad[] = {
        {{.restitution = -0x1p-1074}, "restitution"},
        {{.restitution = 1 + 0x1p-52}, "restitution"},
        {{.restitution = NAN}, "restitution"},
        {{.restitution_threshold = -0x1p-1074}, "restitution_threshold"},
        {{.restitution_threshold = INFINITY}, "restitution_threshold"},
        {{.restitution_threshold = NAN}, "restitution_threshold"},
        {{.thickness = -0x1p-1074}, "thickness"},
        {{.thickness = INFINITY}, "thickness"},
        {{.thickness = NAN}, "thickness"},
        {{.friction = -0x1p-1074}, "friction"},
        {{.friction = INFINITY}, "friction"},
        {{.friction = NAN}, "friction"},
        {{.separation = INFINITY}, "separation"},
        {{.separation = -INFINITY}, "separation"},
        {{.separation = NAN}, "separation"},
        {{.sweeps = -1}, "sweeps"},
        {{.substeps = -1}, "substeps"},
        {{.substeps = 2, .draft = true}, "substeps"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        tf_error error;
        ck_assert_int_eq(tf_response_options_check(&bad[i].options, &error),
                         TF_BAD_OPTION);
        ck_assert_str_eq(error.option, bad[i].option);
    }
}
END_TEST

START_TEST(limits_of_ranges_are_in_them)
{
    static const tf_response_options good[] = {
        {0},
        {.restitution = 1},
        {.restitution_threshold = 1e308},
        {.thickness = 1e308},
        {.friction = 1e308, .separation = -1e308},
        {.impulse_rounds = -1, .zone_rounds = -1},
        {.substeps = INT_MAX},
        {.substeps = 1, .draft = true},
        {.substeps = 2, .again = true},
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        tf_error error = {.option = "left"};
        ck_assert_int_eq(tf_response_options_check(&good[i], &error), TF_OK);
        ck_assert_str_eq(error.option, "left");
    }
}
END_TEST

START_TEST(zeros_are_the_usual_choices)
{
    tf_response_options options;
    tf_error error;
    ck_assert_int_eq(tf_response_options_read(&options, NULL, &error), TF_OK);
    ck_assert_ptr_nonnull(options.narrow_phase);
    tf_response_options given = {.parallel = &(tf_parallel){.workers = 0}};
    ck_assert_int_eq(tf_response_options_read(&options, &given, &error),
                     TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "parallel.workers");
}
END_TEST

// A caller who says no size has the options of version 1.0, and no younger ones.
START_TEST(options_without_a_size_are_the_first_ones)
{
    int context;
    tf_response_options options,
        given = {.friction = 2, .context = &context, .thickness = 3};
    ck_assert_int_eq(tf_response_options_read(&options, &given, NULL), TF_OK);
    ck_assert_double_eq(options.friction, 2);
    ck_assert_ptr_eq(options.context, &context);
    ck_assert_double_eq(options.thickness, 0);
    given.size = sizeof given;
    ck_assert_int_eq(tf_response_options_read(&options, &given, NULL), TF_OK);
    ck_assert_double_eq(options.thickness, 3);
}
END_TEST

/// Chooses for a triangle with sides of 3, 4 and 5 times a length.
static void choose(tf_response_options *options, double length)
{
    static const int triangle[] = {0, 1, 2};
    double start[] = {0, 0, 0, 3 * length, 0, 0, 0, 4 * length, 0};
    tf_surface *surface = surface_of(&(tf_mesh){
        .axes = 3, .vertices = 3, .triangles = 1, .triangle = triangle});
    tf_step step = {.axes = 3, .vertices = 3, .start = start};
    tf_response_options_choose(options, surface, &step);
    tf_surface_free(surface);
}

START_TEST(what_is_not_chosen_is_the_usual)
{
    tf_response_options options = {0};
    choose(&options, 10);
    ck_assert_ptr_eq(options.solver, &tf_gauss_seidel);
    ck_assert_int_eq(options.zone_rounds, 20);
    ck_assert_int_eq(options.sweeps, 30);
    ck_assert_double_eq_tol(options.separation, 0.05 * 40, 1e-12);
    options.separation = 0;
    choose(&options, 0x1p1022); // lengths that overflow
    ck_assert_double_eq(options.separation, 0);
}
END_TEST

START_TEST(what_is_chosen_stays)
{
    tf_response_options options = {
        .solver = &tf_minres, .zone_rounds = -1, .sweeps = 7, .separation = -2};
    choose(&options, 1);
    ck_assert_ptr_eq(options.solver, &tf_minres);
    ck_assert_int_eq(options.zone_rounds, -1);
    ck_assert_int_eq(options.sweeps, 7);
    ck_assert_double_eq(options.separation, -2);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/choices");
    TCase *tcase = tcase_create("choices");
    tcase_add_test(tcase, options_out_of_range_are_named);
    tcase_add_test(tcase, limits_of_ranges_are_in_them);
    tcase_add_test(tcase, zeros_are_the_usual_choices);
    tcase_add_test(tcase, options_without_a_size_are_the_first_ones);
    tcase_add_test(tcase, what_is_not_chosen_is_the_usual);
    tcase_add_test(tcase, what_is_chosen_stays);
    suite_add_tcase(suite, tcase);
    return suite;
}
