// Nearness, against distances in rational numbers.
#include "distance/nearer.h"

#include "distance/nearest.h"
#include "support/exact_distance.h"
#include "support/rest_pairs.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

static void expect_true_answer(const rest_pair *pair, double length)
{
    if (!(length > 0) || length > DBL_MAX)
        return;
    bool expected = exact_distance_compare(pair->kind, pair->x, length) < 0;
    ck_assert_msg(tf_are_nearer(pair->kind, pair->x, length) == expected,
                  "seed %llu, %s, not nearer than %a: %d",
                  (unsigned long long)seed(), rest_pair_text(pair), length,
                  expected);
    int estimate = tf_estimate_nearer(pair->kind, pair->x, length);
    ck_assert_msg(estimate == 0 || (estimate > 0) == expected,
                  "seed %llu, %s, estimate %d for %a",
                  (unsigned long long)seed(), rest_pair_text(pair), estimate,
                  length);
}

START_TEST(elements_are_nearer_where_rational_numbers_say_so)
{
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(_i == 6 ? 20 : 100); i > 0; i--) {
        rest_pair pair;
        rest_pair_make(&random, _i, &pair);
        tf_nearest nearest = tf_nearest_of(pair.kind, pair.x);
        expect_true_answer(&pair, nearest.upper * uniform(&random, 0, 2));
        double length = nearest.lower;
        for (int j = 0; j < 3; j++)
            length = nextafter(length, 0);
        for (int j = 0; j < 8; j++, length = nextafter(length, INFINITY))
            expect_true_answer(&pair, length);
        expect_true_answer(&pair, nearest.lower / 2 + nearest.upper / 2);
        expect_true_answer(&pair, DBL_TRUE_MIN);
        expect_true_answer(&pair, DBL_MAX);
    }
}
END_TEST

START_TEST(elements_at_a_distance_are_not_nearer)
{
    static const double at[] = {0, 0, 0, 3, 4, -9, 3, 4, 0, 3, 4, 7};
    double scaled[12];
    const double *x[] = {scaled, scaled + 3, scaled + 6, scaled + 9};
    for (int exponent = -1074; exponent < 1020; exponent++) {
        for (int i = 0; i < 12; i++)
            scaled[i] = ldexp(at[i], exponent);
        double length = ldexp(5, exponent);
        ck_assert(!tf_are_nearer(TF_POINT_TRIANGLE, x, length));
        ck_assert(!tf_are_nearer(TF_POINT_TRIANGLE, x, nextafter(length, 0)));
        ck_assert(
            tf_are_nearer(TF_POINT_TRIANGLE, x, nextafter(length, INFINITY)));
    }
}
END_TEST

// An edge ends above the middle of another, so near that its length, rounded, may be
// off by as much.
START_TEST(rounding_widens_no_gap)
{
    generator random = generator_new(200);
    for (long i = cases(2000); i > 0; i--) {
        double at[12] = {0}, high = uniform(&random, 0.5, 1), low = high;
        int up = below(&random, 3), along = (up + 1) % 3;
        for (int j = below(&random, 8); j >= 0; j--)
            low = nextafter(low, 0);
        at[up] = uniform(&random, 1, 3);
        at[3 + up] = high;
        at[6 + up] = at[9 + up] = low;
        at[6 + along] = -1;
        at[9 + along] = 1;
        int scale = 200 * (below(&random, 3) - 1);
        for (int k = 0; k < 12; k++)
            at[k] = ldexp(at[k], scale);
        const double *x[] = {at, at + 3, at + 6, at + 9};
        double gap = ldexp(high - low, scale);
        ck_assert(!tf_are_nearer(TF_EDGE_EDGE, x, gap));
        ck_assert(tf_are_nearer(TF_EDGE_EDGE, x, nextafter(gap, INFINITY)));
    }
}
END_TEST

START_TEST(edges_through_one_middle_are_nearer_than_any_length)
{
    static const double at[] = {-1, 0, 0, 1, 0, 0, 0, -1, 0, 0, 1, 0};
    const double *x[] = {at, at + 3, at + 6, at + 9};
    for (int exponent = -1074; exponent < 1024; exponent++)
        ck_assert(tf_are_nearer(TF_EDGE_EDGE, x, ldexp(1, exponent)));
}
END_TEST

START_TEST(estimates_decide_nearly_all_usual_pairs)
{
    generator random = generator_new(100);
    int open = 0;
    for (int i = 0; i < 1000; i++) {
        rest_pair pair;
        rest_pair_make(&random, 0, &pair);
        open +=
            tf_estimate_nearer(pair.kind, pair.x, uniform(&random, 0, 1)) == 0;
    }
    ck_assert_int_le(open, 3);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/nearer");
    TCase *tcase = tcase_create("nearer");
    tcase_add_loop_test(tcase,
                        elements_are_nearer_where_rational_numbers_say_so, 0,
                        REST_FAMILIES);
    tcase_add_test(tcase, elements_at_a_distance_are_not_nearer);
    tcase_add_test(tcase, rounding_widens_no_gap);
    tcase_add_test(tcase, edges_through_one_middle_are_nearer_than_any_length);
    tcase_add_test(tcase, estimates_decide_nearly_all_usual_pairs);
    suite_add_tcase(suite, tcase);
    return suite;
}
