// Certain separation, against verdicts by rational arithmetic.
#include "query/apart.h"

#include "query/query.h"
#include "support/families.h"
#include "support/rational.h"
#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/// Whether a query is certainly apart; then it must be so by rational signs.
static bool is_apart(query *q)
{
    tf_difference_list list = {.count = 0};
    double at[2][3 * QUERY_VERTICES];
    const double *x[QUERY_VERTICES];
    int corner[QUERY_VERTICES];
    for (int t = 0; t < 2; t++) {
        for (int v = 0; v < QUERY_VERTICES; v++) {
            corner[v] = v;
            x[v] = &at[t][3 * v];
            for (int k = 0; k < 3; k++)
                at[t][3 * v + k] =
                    *query_coordinate(q, (t * QUERY_VERTICES + v) * 3 + k);
        }
        tf_list_differences(q->vertices, q->others, x, &list);
    }
    tf_motion motion = {3, QUERY_VERTICES, at[0], at[1]};
    if (!tf_certainly_apart(&list))
        return false;
    tf_verdict verdict = TF_UNDECIDED;
    bool separated = false;
    ck_assert_int_eq(
        tf_query_verdict(&oracle_arithmetic, 3, &motion, q->vertices, corner,
                         q->others, corner + q->vertices, &verdict, &separated),
        TF_OK);
    ck_assert_msg(verdict == TF_APART, "seed %llu, %s\n%s",
                  (unsigned long long)seed(), query_name(q), query_text(q));
    return true;
}

static query_kind kind_of(int i)
{
    return i % 2 ? EDGE_EDGE : POINT_TRIANGLE;
}

START_TEST(what_is_apart_is_so_by_rational_signs)
{
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(500); i > 0; i--) {
        query q = families[_i / 2].make(&random, kind_of(_i));
        is_apart(&q);
        query_nudge(&random, &q, 2);
        is_apart(&q);
    }
}
END_TEST

// At the boundary -------------------------------------------------------------

/// A query at rest, of the scaled coordinates of its four vertices.
static query rest(query_kind kind, const double x[QUERY_VERTICES][3],
                  double scale)
{
    query q = query_new(kind);
    for (int t = 0; t < 2; t++)
        for (int v = 0; v < QUERY_VERTICES; v++)
            for (int k = 0; k < 3; k++)
                *query_coordinate(&q, (t * QUERY_VERTICES + v) * 3 + k) =
                    scale * x[v][k];
    return q;
}

/// A point by the long side of a triangle, or an edge by another.
static const double side_by_side[2][QUERY_VERTICES][3] = {
    {{1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
    {{0, 0, 0}, {1, 1, 0}, {1, 0.5, 0}, {2, 1.5, 0}},
};

START_TEST(neighbors_of_a_flat_grid_are_apart_at_usual_scales)
{
    for (int exponent = -1000; exponent <= 1000; exponent += 10) {
        query q = rest(kind_of(_i), side_by_side[_i], ldexp(1, exponent));
        bool apart = is_apart(&q);
        ck_assert_msg(apart || abs(exponent) > 290, "2^%d", exponent);
        ck_assert_msg(!apart || exponent <= 511, "2^%d", exponent);
    }
}
END_TEST

START_TEST(touching_elements_are_not_apart_nor_an_ulp_to_each_side)
{
    static const double touching[2][QUERY_VERTICES][3] = {
        {{0.5, 0.5, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        {{0, 0, 0}, {1, 1, 0}, {0.5, 0.5, 0}, {2, 0, 0}},
    };
    for (int exponent = -1000; exponent <= 1000; exponent += 10)
        for (int v = 0; v < QUERY_VERTICES; v++)
            for (int side = -1; side <= 1; side++) {
                query q = rest(kind_of(_i), touching[_i], ldexp(1, exponent));
                for (int t = 0; t < 2; t++) {
                    double *x =
                        query_coordinate(&q, (t * QUERY_VERTICES + v) * 3);
                    *x = side ? nextafter(*x, side > 0 ? INFINITY : -INFINITY)
                              : *x;
                }
                ck_assert_msg(!is_apart(&q) || side != 0, "2^%d", exponent);
            }
}
END_TEST

START_TEST(a_small_gap_along_a_diagonal_is_found)
{
    for (double gap = 0x1p-40; gap < 4; gap *= 2) {
        query q = rest(POINT_TRIANGLE, side_by_side[0], 1);
        for (int t = 0; t < 2; t++)
            for (int k = 0; k < 2; k++)
                *query_coordinate(&q, t * QUERY_VERTICES * 3 + k) = 0.5 + gap;
        ck_assert_msg(is_apart(&q), "%a", gap);
    }
}
END_TEST

START_TEST(what_passes_from_side_to_side_is_not_apart)
{
    query q = rest(POINT_TRIANGLE, side_by_side[0], 1);
    for (int k = 0; k < 2; k++)
        *query_coordinate(&q, QUERY_VERTICES * 3 + k) = -1;
    ck_assert(!is_apart(&q));
}
END_TEST

START_TEST(numbers_that_are_not_finite_show_nothing)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, DBL_MAX};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3 * QUERY_VERTICES; j++) {
            double x[QUERY_VERTICES][3] = {
                {0, 0, 0}, {1, 1, 0}, {1, 0.5, 0}, {2, 1.5, 0}};
            const double *at[] = {x[0], x[1], x[2], x[3]};
            tf_difference_list good = {.count = 0}, wrong = {.count = 0};
            tf_list_differences(2, 2, at, &good);
            ck_assert(tf_certainly_apart(&good));
            x[j / 3][j % 3] = bad[i];
            tf_list_differences(2, 2, at, &wrong);
            ck_assert(!tf_certainly_apart(&wrong));
        }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/apart");
    TCase *tcase = tcase_create("apart");
    tcase_add_loop_test(tcase, what_is_apart_is_so_by_rational_signs, 0,
                        2 * FAMILIES);
    tcase_add_loop_test(
        tcase, neighbors_of_a_flat_grid_are_apart_at_usual_scales, 0, 2);
    tcase_add_loop_test(
        tcase, touching_elements_are_not_apart_nor_an_ulp_to_each_side, 0, 2);
    tcase_add_test(tcase, a_small_gap_along_a_diagonal_is_found);
    tcase_add_test(tcase, what_passes_from_side_to_side_is_not_apart);
    tcase_add_test(tcase, numbers_that_are_not_finite_show_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
