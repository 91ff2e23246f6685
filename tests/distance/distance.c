// What the queries of distances ask of their callers.
#include "distance/distance.h"

#include "distance/nearest.h"
#include "support/environments.h"
#include "support/rest_pairs.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

static const double square[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 2};

START_TEST(vertices_are_taken_by_their_indices)
{
    static const int over[] = {3, 2, 1, 0}, edges[] = {3, 1, 0, 2};
    tf_nearest found;
    bool nearer;
    ck_assert_int_eq(tf_distance(TF_POINT_TRIANGLE, 4, square, over, &found),
                     TF_OK);
    ck_assert(found.lower <= 2 && found.upper >= 2);
    ck_assert_double_eq_tol(found.barycentric[1][2], 0.5, 1e-15);
    ck_assert_int_eq(
        tf_is_nearer(TF_POINT_TRIANGLE, 4, square, over, 2, &nearer), TF_OK);
    ck_assert(!nearer);
    ck_assert_int_eq(tf_is_nearer(TF_EDGE_EDGE, 4, square, edges, 1, &nearer),
                     TF_OK);
    ck_assert(nearer);
}
END_TEST

static const int good[] = {0, 1, 2, 3};

START_TEST(what_is_bad_is_told)
{
    static const int none[] = {0, 1, 2, 4}, negative[] = {-1, 1, 2, 3};
    tf_nearest found;
    bool nearer;
    tf_kind no_kind = TF_NO_KIND;
    ck_assert_int_eq(tf_distance(no_kind, 4, square, good, &found),
                     TF_BAD_OPTION);
    ck_assert_int_eq(tf_distance(TF_EDGE_EDGE, 4, square, none, &found),
                     TF_BAD_INDEX);
    ck_assert_int_eq(tf_distance(TF_EDGE_EDGE, 4, square, negative, &found),
                     TF_BAD_INDEX);
    double lengths[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(
            tf_is_nearer(TF_EDGE_EDGE, 4, square, good, lengths[i], &nearer),
            TF_BAD_OPTION);
}
END_TEST

START_TEST(no_vertex_may_come_twice)
{
    tf_nearest found;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < i; j++) {
            int twice[] = {0, 1, 2, 3};
            twice[i] = twice[j];
            ck_assert_int_eq(
                tf_distance(TF_EDGE_EDGE, 4, square, twice, &found),
                TF_BAD_INDEX);
        }
}
END_TEST

START_TEST(every_coordinate_must_be_finite)
{
    tf_nearest found;
    for (int i = 0; i < 12; i++) {
        double bad[12];
        memcpy(bad, square, sizeof bad);
        bad[i] = i % 2 ? NAN : INFINITY;
        ck_assert_int_eq(tf_distance(TF_EDGE_EDGE, 4, bad, good, &found),
                         TF_NOT_FINITE);
    }
}
END_TEST

START_TEST(a_broken_environment_is_told)
{
    tf_nearest found = {.lower = 42};
    bool nearer;
    environment_break(_i);
    tf_status distance = tf_distance(TF_EDGE_EDGE, 4, square, good, &found);
    tf_status decision =
        tf_is_nearer(TF_EDGE_EDGE, 4, square, good, 1, &nearer);
    environment_restore();
    ck_assert_int_eq(distance, TF_BAD_ENVIRONMENT);
    ck_assert_int_eq(decision, TF_BAD_ENVIRONMENT);
    ck_assert_double_eq(found.lower, 42);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/distance");
    TCase *tcase = tcase_create("distance");
    tcase_add_test(tcase, vertices_are_taken_by_their_indices);
    tcase_add_test(tcase, what_is_bad_is_told);
    tcase_add_test(tcase, no_vertex_may_come_twice);
    tcase_add_test(tcase, every_coordinate_must_be_finite);
    tcase_add_loop_test(tcase, a_broken_environment_is_told, 0, environments());
    suite_add_tcase(suite, tcase);
    return suite;
}
