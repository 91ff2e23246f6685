// Near pairs of a surface, as users ask for them.
#include "distance/near_pairs.h"

#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>
#include <string.h>

static const int triangle[] = {0, 1, 2};
static const double at[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0.5};

static tf_surface *new_surface(void)
{
    return surface_of(&(tf_mesh){
        .axes = 3, .vertices = 4, .triangles = 1, .triangle = triangle});
}

START_TEST(near_pairs_are_listed)
{
    tf_surface *surface = new_surface();
    tf_near_pairs found;
    ck_assert_int_eq(tf_surface_near(surface, 4, at, 0.5, NULL, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, 0);
    ck_assert_int_eq(
        tf_surface_near(surface, 4, at, nextafter(0.5, 1), NULL, &found, NULL),
        TF_OK);
    ck_assert_uint_eq(found.count, 1);
    static const int expected[] = {3, 0, 1, 2};
    ck_assert_int_eq(found.pair->kind, TF_POINT_TRIANGLE);
    ck_assert_mem_eq(found.pair->vertex, expected, sizeof expected);
    tf_surface_free(surface);
}
END_TEST

START_TEST(what_cannot_be_asked_is_told)
{
    tf_surface *surface = new_surface();
    tf_near_pairs found;
    tf_error error;
    const double lengths[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(
            tf_surface_near(surface, 4, at, lengths[i], NULL, &found, &error),
            TF_BAD_OPTION);
        ck_assert_str_eq(error.option, "length");
    }
    ck_assert_int_eq(tf_surface_near(surface, 3, at, 1, NULL, &found, &error),
                     TF_BAD_COUNT);
    double bad[12];
    memcpy(bad, at, sizeof bad);
    bad[7] = INFINITY;
    ck_assert_int_eq(tf_surface_near(surface, 4, bad, 1, NULL, &found, &error),
                     TF_NOT_FINITE);
    ck_assert_int_eq(error.vertex[0], 2);
    tf_surface_free(surface);
}
END_TEST

static bool refuse(void *context, const tf_stage *stage)
{
    (void)stage;
    ++*(int *)context;
    return false;
}

START_TEST(a_search_can_be_cancelled)
{
    tf_surface *surface = new_surface();
    tf_near_pairs found;
    int calls = 0;
    tf_check_options options = {.progress = refuse, .context = &calls};
    ck_assert_int_eq(tf_surface_near(surface, 4, at, 1, &options, &found, NULL),
                     TF_CANCELLED);
    ck_assert_int_gt(calls, 0);
    ck_assert_int_eq(tf_surface_near(surface, 4, at, 1, NULL, &found, NULL),
                     TF_OK);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/near_pairs");
    TCase *tcase = tcase_create("near_pairs");
    tcase_add_test(tcase, near_pairs_are_listed);
    tcase_add_test(tcase, what_cannot_be_asked_is_told);
    tcase_add_test(tcase, a_search_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}
