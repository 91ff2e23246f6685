#include "response/choices.h"

#include "support/support.h"

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

Suite *suite(void)
{
    Suite *suite = suite_create("response/choices");
    TCase *tcase = tcase_create("choices");
    tcase_add_test(tcase, options_out_of_range_are_named);
    tcase_add_test(tcase, limits_of_ranges_are_in_them);
    tcase_add_test(tcase, zeros_are_the_usual_choices);
    suite_add_tcase(suite, tcase);
    return suite;
}
