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
    tcase_add_test(tcase, estimates_decide_nearly_all_usual_pairs);
    suite_add_tcase(suite, tcase);
    return suite;
}
