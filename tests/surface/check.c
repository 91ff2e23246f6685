// The static check, against linear programs in rational numbers.
#include "surface/check.h"

#include "support/crossings.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

static oracle_crossings all;

static void compare(const tf_crossings *found)
{
    ck_assert_uint_eq(found->count, (size_t)all.count);
    for (int i = 0; i < all.count; i++) {
        ck_assert_int_eq(found->crossing[i].kind, all.row[i].kind);
        for (int j = 0; j < 5; j++)
            ck_assert_int_eq(found->crossing[i].vertex[j],
                             all.row[i].vertex[j]);
    }
}

static void compare_surfaces(int count, int elements, placement placed,
                             int stream)
{
    static surface_case given;
    generator random = generator_new((uint64_t)stream);
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    for (int i = 0; i < count; i++) {
        random_surface(&random, 2 + i % 2, elements, placed, &given);
        tf_surface *surface = surface_of(&given.mesh);
        tf_crossings found;
        oracle_crossings_find(&all, surface, given.mesh.axes,
                              given.mesh.vertices, given.start);
        for (int j = 0; j < 2; j++) {
            ck_assert_int_eq(
                tf_surface_check(
                    surface, given.mesh.vertices, given.start,
                    &(tf_check_options){.parallel = j ? &parallel : NULL},
                    &found, NULL),
                TF_OK);
            compare(&found);
        }
        tf_surface_free(surface);
    }
}

START_TEST(intersections_are_those_of_all_pairs)
{
    compare_surfaces((int)cases(60), 8, (placement)_i, 100 + _i);
}
END_TEST

// By hand ---------------------------------------------------------------------

/// Two triangles: one in the plane z = 0, the other as given.
static size_t count_rows(const double other[9], tf_crossing *first)
{
    static const int triangle[] = {0, 1, 2, 3, 4, 5};
    double position[18] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    memcpy(position + 9, other, 9 * sizeof *other);
    tf_mesh mesh = {
        .axes = 3, .vertices = 6, .triangles = 2, .triangle = triangle};
    tf_surface *surface = surface_of(&mesh);
    tf_crossings found;
    ck_assert_int_eq(tf_surface_check(surface, 6, position, NULL, &found, NULL),
                     TF_OK);
    size_t count = found.count;
    if (count > 0)
        *first = *found.crossing;
    tf_surface_free(surface);
    return count;
}

// Where two triangles pierce each other a segment begins and ends: here on an
// edge of each.
START_TEST(edges_through_triangles_are_found)
{
    static const double piercing[] = {1, 1, -1, 1, 1, 1, 9, 9, 1};
    tf_crossing row;
    ck_assert_uint_eq(count_rows(piercing, &row), 2);
    ck_assert_int_eq(row.kind, TF_EDGE_THROUGH_TRIANGLE);
    static const int expected[] = {1, 2, 3, 4, 5};
    ck_assert_mem_eq(row.vertex, expected, sizeof expected);
}
END_TEST

START_TEST(a_touch_counts_and_an_ulp_above_does_not)
{
    double touching[] = {1, 1, 0, 1, 1, 1, 2, 1, 1};
    tf_crossing row;
    ck_assert_uint_eq(count_rows(touching, &row), 1);
    ck_assert_int_eq(row.kind, TF_POINT_ON_TRIANGLE);
    ck_assert_int_eq(row.vertex[0], 3);
    touching[2] = 4.9e-324;
    ck_assert_uint_eq(count_rows(touching, &row), 0);
}
END_TEST

// Trouble ---------------------------------------------------------------------

START_TEST(bad_input_is_reported)
{
    static const int triangle[] = {0, 1, 2};
    tf_mesh mesh = {
        .axes = 3, .vertices = 3, .triangles = 1, .triangle = triangle};
    tf_surface *surface = surface_of(&mesh);
    double position[] = {0, 0, 0, 1, 0, NAN, 0, 1, 0};
    tf_crossings found;
    tf_error error;
    ck_assert_int_eq(
        tf_surface_check(surface, 3, position, NULL, &found, &error),
        TF_NOT_FINITE);
    ck_assert_int_eq(error.subject, TF_VERTEX);
    ck_assert_uint_eq(error.index, 1);
    ck_assert_int_eq(tf_surface_check(surface, 2, position, NULL, &found, NULL),
                     TF_BAD_COUNT);
    tf_surface_free(surface);
}
END_TEST

START_TEST(null_breaks_the_contract)
{
    tf_crossings found;
    tf_surface_check(NULL, 1, (double[3]){0}, NULL, &found, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/check");
    TCase *tcase = tcase_create("all pairs");
    tcase_add_loop_test(tcase, intersections_are_those_of_all_pairs, 0,
                        PLACEMENTS);
    suite_add_tcase(suite, tcase);

    TCase *few = tcase_create("by hand");
    tcase_add_test(few, edges_through_triangles_are_found);
    tcase_add_test(few, a_touch_counts_and_an_ulp_above_does_not);
    tcase_add_test(few, bad_input_is_reported);
    tcase_add_test_raise_signal(few, null_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, few);
    return suite;
}
