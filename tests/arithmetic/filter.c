#include "arithmetic/filter.h"

#include "arithmetic/functions.h"
#include "support/estimates.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>

static bool decides(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    tf_estimate e = tf_differences_estimate(&differences);
    return fabs(e.number) > e.bound || (e.number == 0 && e.bound == 0);
}

static void judge(const matrix *m)
{
    judged_estimate j;
    judged_estimate_init(&j, m);
    expect_of_matrix(estimate_is_true(&j), "The estimate decides wrongly", m);
    expect_of_matrix(bound_is_kept(&j), "The error is beyond the bound", m);
    judged_estimate_clear(&j);
}

static void use(void)
{
    static const estimate_test test = {judge, decides};
    estimates_use(&test);
}

// Signs -----------------------------------------------------------------------

START_TEST(signs_of_random_numbers_are_known)
{
    // Less than one in 2^40 is not.
    generator random = generator_new(1);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 1 + below(&random, TF_AXES));
        for (int k = 0; k < matrix_size(&m); k++)
            *matrix_coordinate(&m, k) = uniform(&random, -1, 1);
        judge(&m);
        expect_of_matrix(decides(&m), "The estimate does not decide", &m);
    }
}
END_TEST

START_TEST(an_empty_matrix_breaks_the_contract)
{
    tf_differences nothing = {.n = 0};
    tf_differences_estimate(&nothing);
}
END_TEST

// Bounds ----------------------------------------------------------------------

/// The error but for the last addition, at least, as a share of the bound.
static double share(const matrix *m)
{
    judged_estimate j;
    judged_estimate_init(&j, m);
    expect_of_matrix(bound_is_kept(&j), "The error is beyond the bound", m);
    expect_of_matrix(radius_is_kept(&j), "The error is beyond the radius", m);
    sum_add(j.error, -last_place(j.estimate.number), 0.5, 1);
    long exponent;
    double error = mpz_get_d_2exp(&exponent, j.error);
    judged_estimate_clear(&j);
    return ldexp(error, (int)exponent + SUM_EXPONENT) / j.estimate.bound;
}

/// Choose a subtrahend that rounding takes away: half a last place at most.
static double choose_lost(generator *random, double to)
{
    return uniform(random, -0.5, 0.5) * last_place(to);
}

/// Choose an entry anew: just above a power of two, where a last place is
/// largest.
static void choose_entry(generator *random, matrix *m, int i)
{
    double sign = below(random, 2) ? 1 : -1;
    double more = ldexp(uniform(random, 0, 1), -20 - below(random, 10));
    int exponent = below(random, 2) ? 0 : -below(random, 60);
    double to = ldexp(sign * (1 + more), exponent);
    *matrix_coordinate(m, i) = to;
    *matrix_coordinate(m, i + 1) = choose_lost(random, to);
}

/// Change some entry: by a few last places, or altogether.
static void change(generator *random, matrix *m)
{
    int i = 2 * below(random, m->n * m->n);
    double *to = matrix_coordinate(m, i), *from = matrix_coordinate(m, i + 1);
    switch (below(random, 4)) {
    case 0:
        choose_entry(random, m, i);
        break;
    case 1:
        *to += (below(random, 7) - 3) * last_place(*to);
        break;
    case 2:
        *to *= 1 + uniform(random, -0x1p-26, 0x1p-26);
        break;
    default:
        *from = choose_lost(random, *to);
    }
}

/// The largest share found by climbing from a random matrix.
static double climb(generator *random, int n, long steps)
{
    matrix best = matrix_new(random, n);
    for (int i = 0; i < matrix_size(&best); i += 2)
        choose_entry(random, &best, i);
    double worst = share(&best);
    for (long step = 0; step < steps; step++) {
        matrix next = best;
        change(random, &next);
        double next_share = share(&next);
        if (next_share >= worst) {
            worst = next_share;
            best = next;
        }
    }
    return worst;
}

static void expect_tight_bound(int n, double least)
{
    generator random = generator_new(10 + (uint64_t)n);
    long climbs = 3 + cases(20);
    double worst = 0;
    for (long i = 0; i < climbs; i++)
        worst = fmax(worst, climb(&random, n, 5000));
    printf("worst error of %dx%d found: %.3f of the bound\n", n, n, worst);
    ck_assert_msg(worst >= least, "The bound is %.2f times the worst error",
                  1 / worst);
}

START_TEST(bounds_are_not_much_more_than_the_worst_error)
{
    expect_tight_bound(2, 0.8);
    expect_tight_bound(3, 0.5);
}
END_TEST

// Underflow -------------------------------------------------------------------

/// The bound of a 3x3 determinant that always adds what underflow can lose.
static double plain_bound(const matrix *m)
{
    double e[TF_AXES][TF_AXES];
    tf_differences differences = matrix_differences(m);
    tf_differences_round(&differences, e);
    double ax = fabs(e[0][0]), ay = fabs(e[0][1]), az = fabs(e[0][2]);
    double permanent =
        ax * (fabs(e[1][1] * e[2][2]) + fabs(e[1][2] * e[2][1])) +
        ay * (fabs(e[1][2] * e[2][0]) + fabs(e[1][0] * e[2][2])) +
        az * (fabs(e[1][0] * e[2][1]) + fabs(e[1][1] * e[2][0]));
    return (7 + 0x1p-40) * (DBL_EPSILON / 2) * permanent +
           0x1p-1071 * (ax + ay + az + 1);
}

static bool same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

/// Whether the bound is the plain one, bit for bit; none is needed where every
/// term is certainly zero.
static void expect_plain_bound(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    tf_estimate e = tf_differences_estimate(&differences);
    bool zero = e.number == 0 && e.bound == 0;
    expect_of_matrix(zero || same(e.bound, plain_bound(m)),
                     "The bound leaves out what underflow loses", m);
}

/// Entries of about 2^exponent[row].
static matrix matrix_of_rows(generator *random, const int exponent[TF_AXES])
{
    matrix m = matrix_new(random, TF_AXES);
    for (int k = 0; k < matrix_size(&m); k += 2) {
        double x = ldexp(uniform(random, 1, 2), exponent[k / 2 / TF_AXES]);
        *matrix_coordinate(&m, k) = below(random, 2) ? -x : x;
    }
    return m;
}

START_TEST(the_bound_is_the_plain_one_at_all_magnitudes)
{
    generator random = generator_new(20);
    long count = cases(200000);
    for (long i = 0; i < count; i++) {
        int exponent[TF_AXES];
        for (int row = 0; row < TF_AXES; row++)
            exponent[row] = below(&random, 2046) - 1023;
        matrix m = i % 2 ? matrix_of_rows(&random, exponent)
                         : matrix_any(&random, TF_AXES);
        expect_plain_bound(&m);
    }
}
END_TEST

/// A permanent between 2^-983 and 2^-954 times 1 or the largest entry of the
/// first row: the underflow term counts from about 2^-967 down.
static matrix beside_the_switch(generator *random)
{
    int first = below(random, 1500) - 1000;
    int permanent = -961 + (first > 0 ? first : 0) + below(random, 30) - 22;
    int product = permanent - first;
    if (product > 1000 || product < -1070)
        return matrix_any(random, TF_AXES);
    int exponent[TF_AXES] = {first, product / 2, product - product / 2};
    return matrix_of_rows(random, exponent);
}

START_TEST(the_bound_is_the_plain_one_where_it_is_left_out)
{
    generator random = generator_new(21);
    long count = cases(200000);
    for (long i = 0; i < count; i++) {
        matrix m = beside_the_switch(&random);
        expect_plain_bound(&m);
        judge(&m);
    }
}
END_TEST

START_TEST(estimates_are_true_where_products_of_three_underflow)
{
    generator random = generator_new(22);
    long count = cases(40000);
    for (long i = 0; i < count; i++) {
        matrix m;
        if (i % 2) {
            int exponent[TF_AXES];
            for (int row = 0; row < TF_AXES; row++)
                exponent[row] = -360 + below(&random, 21);
            m = matrix_of_rows(&random, exponent);
        } else {
            m = matrix_close(&random, TF_AXES, 0);
            for (int j = 0; j < TF_AXES; j++)
                matrix_scale(&m, j, -360 + below(&random, 21));
        }
        judge(&m);
        expect_plain_bound(&m);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *filter = suite_create("filter");
    estimates_add(filter, use);
    TCase *signs = tcase_create("other signs");
    tcase_add_test(signs, signs_of_random_numbers_are_known);
    tcase_add_test_raise_signal(signs, an_empty_matrix_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(filter, signs);
    TCase *bounds = tcase_create("bounds");
    tcase_add_test(bounds, bounds_are_not_much_more_than_the_worst_error);
    suite_add_tcase(filter, bounds);
    TCase *underflow = tcase_create("underflow");
    tcase_add_test(underflow, the_bound_is_the_plain_one_at_all_magnitudes);
    tcase_add_test(underflow, the_bound_is_the_plain_one_where_it_is_left_out);
    tcase_add_test(underflow,
                   estimates_are_true_where_products_of_three_underflow);
    suite_add_tcase(filter, underflow);
    return filter;
}
