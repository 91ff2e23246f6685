#include "fast/detect.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "surface/detect.h"

#include <signal.h>
#include <string.h>

static surface_case made;

/// Vectors are the default, and give the rows of the reference.
START_TEST(rows_are_those_of_the_reference)
{
    generator random = generator_new((uint64_t)_i);
    random_surface(&random, 2 + _i % 2, 40, (placement)(_i % PLACEMENTS),
                   &made);
    tf_surface *one = surface_of(&made.mesh), *other = surface_of(&made.mesh);
    tf_contacts expected, found;
    tf_error error;
    ck_assert_int_eq(tf_detect(one, &made.motion, NULL, &expected, NULL),
                     TF_OK);
    ck_assert_int_eq(
        tf_surface_detect(other, &made.motion, NULL, &found, &error), TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    ck_assert_uint_eq(found.count, expected.count);
    ck_assert_int_eq(memcmp(found.contact, expected.contact,
                            found.count * sizeof *found.contact),
                     0);
    tf_surface_free(one);
    tf_surface_free(other);
}
END_TEST

static const int corner[] = {0, 1, 2};
static const tf_mesh simple = {
    .axes = 3, .vertices = 3, .triangles = 1, .triangle = corner};
static const double x[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};

static tf_status detect(const tf_motion *motion,
                        const tf_detect_options *options, tf_error *error)
{
    tf_contacts found;
    tf_surface *surface = surface_of(&simple);
    tf_status status =
        tf_surface_detect(surface, motion, options, &found, error);
    ck_assert_int_eq(status, error->status);
    tf_surface_free(surface);
    return status;
}

START_TEST(motions_of_other_surfaces_are_refused)
{
    tf_error error;
    const tf_motion good = {3, 3, x, x};
    tf_motion flat = good, more = good, negative = good, none = good;
    flat.axes = 2;
    more.vertices = 1 << 30;
    negative.vertices = -1;
    none.end = NULL;
    ck_assert_int_eq(detect(&good, NULL, &error), TF_OK);
    ck_assert_int_eq(detect(&flat, NULL, &error), TF_BAD_AXES);
    ck_assert_int_eq(detect(&(tf_motion){0}, NULL, &error), TF_BAD_AXES);
    ck_assert_int_eq(detect(&more, NULL, &error), TF_BAD_COUNT);
    ck_assert_int_eq(detect(&negative, NULL, &error), TF_BAD_COUNT);
    ck_assert_int_eq(detect(&none, NULL, &error), TF_BAD_COUNT);
}
END_TEST

START_TEST(options_out_of_range_are_named)
{
    tf_error error;
    tf_parallel none = {.workers = 0};
    const tf_motion good = {3, 3, x, x};
    ck_assert_int_eq(
        detect(&good, &(tf_detect_options){.parallel = &none}, &error),
        TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "parallel.workers");
    ck_assert_int_eq(detect(&good, &(tf_detect_options){.size = 1}, &error),
                     TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "size");
    ck_assert_int_eq(
        detect(&good,
               &(tf_detect_options){.selection = (tf_contact_selection)9},
               &error),
        TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "selection");
}
END_TEST

START_TEST(null_breaks_the_contract)
{
    tf_contacts found;
    tf_motion motion = {0};
    tf_surface_detect(NULL, &motion, NULL, &found, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/detect");
    TCase *tcase = tcase_create("detect");
    tcase_add_loop_test(tcase, rows_are_those_of_the_reference, 0,
                        (int)cases_at_least(2 * PLACEMENTS, 60));
    tcase_add_test(tcase, motions_of_other_surfaces_are_refused);
    tcase_add_test(tcase, options_out_of_range_are_named);
    tcase_add_test_raise_signal(tcase, null_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
