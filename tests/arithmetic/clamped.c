#include "arithmetic/clamped.h"
#include "support/matrices.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>

// Judging an estimate ---------------------------------------------------------

/// What is true of a determinant and what is told.
typedef struct judged {
    tf_estimate estimate;
    tf_value value;
    tf_sign sign, report;
    mpz_t truth; ///< the determinant
    mpz_t error; ///< of the number, absolute; where it is finite
} judged;

static void judged_init(judged *j, const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    j->estimate = tf_differences_estimate(&differences);
    j->value = tf_clamped.value(&differences);
    j->sign = tf_clamped.sign(&differences);
    j->report = tf_report.sign(&differences);
    mpz_inits(j->truth, j->error, NULL);
    sum_determinant(j->truth, &differences);
    if (isfinite(j->estimate.number)) {
        mpz_set(j->error, j->truth);
        sum_add(j->error, -1, j->estimate.number, 1);
        mpz_abs(j->error, j->error);
    }
}

static void judged_clear(judged *j)
{
    mpz_clears(j->truth, j->error, NULL);
}

/// Whether the error is at most a + b c.
static bool error_within(const judged *j, double a, double b, double c)
{
    mpz_t bound;
    mpz_init(bound);
    sum_add(bound, a, 1, 1);
    sum_add(bound, b, c, 1);
    bool within = mpz_cmp(j->error, bound) <= 0;
    mpz_clear(bound);
    return within;
}

/// The last place of a double.
static double last_place(double x)
{
    return x == 0 ? 0 : fmax(ldexp(1, ilogb(x) - 52), DBL_TRUE_MIN);
}

/// Whether the bound that decides the sign covers all but the last addition.
static bool bound_is_kept(const judged *j)
{
    tf_estimate e = j->estimate;
    return !isfinite(e.number) || !isfinite(e.bound) ||
           error_within(j, e.bound, last_place(e.number), 0.5);
}

/// Whether the value's radius covers all but a last rounding.
static bool radius_is_kept(const judged *j)
{
    tf_value v = j->value;
    return !isfinite(v.number) || !isfinite(v.radius) ||
           error_within(j, v.radius, fabs(v.number), DBL_EPSILON / 2);
}

static bool estimate_is_true(const judged *j)
{
    tf_estimate e = j->estimate;
    tf_sign sign = sum_sign(j->truth);
    if (e.number > e.bound)
        return sign == TF_POSITIVE;
    if (-e.number > e.bound)
        return sign == TF_NEGATIVE;
    return e.number != 0 || e.bound != 0 || sign == TF_ZERO;
}

static void judge(const matrix *m)
{
    judged j;
    judged_init(&j, m);
    tf_sign report = j.sign == TF_UNKNOWN ? TF_ZERO : j.sign;
    expect_of_matrix(j.sign == TF_UNKNOWN || j.sign == sum_sign(j.truth),
                     "The sign is known and wrong", m);
    expect_of_matrix(j.report == report,
                     "The report's sign is not clamped's, unknown as zero", m);
    expect_of_matrix(estimate_is_true(&j), "The estimate tells a wrong sign",
                     m);
    expect_of_matrix(bound_is_kept(&j), "The error is beyond the bound", m);
    expect_of_matrix(radius_is_kept(&j), "The error is beyond the radius", m);
    expect_of_matrix(
        !(j.value.radius < 0) && j.value.exponent == 0 &&
            (j.value.number == j.estimate.number || isnan(j.estimate.number)),
        "The value is not the estimate", m);
    judged_clear(&j);
}

// Signs -----------------------------------------------------------------------

static tf_sign clamped_sign(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    return tf_clamped.sign(&differences);
}

static tf_sign true_sign(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    return oracle_arithmetic.sign(&differences);
}

START_TEST(small_integers_are_known)
{
    for (int n = 1; n <= TF_AXES; n++) {
        double entry[TF_AXES * TF_AXES] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
        do {
            matrix m = matrix_of(n, entry);
            judge(&m);
            expect_of_matrix(true_sign(&m) == TF_ZERO ||
                                 clamped_sign(&m) != TF_UNKNOWN,
                             "The sign is not known", &m);
        } while (next_signs(n * n, entry));
    }
}
END_TEST

START_TEST(random_numbers_are_known)
{
    // Less than one in 2^40 is not.
    generator random = generator_new(1);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 1 + below(&random, TF_AXES));
        for (int k = 0; k < matrix_size(&m); k++)
            *matrix_coordinate(&m, k) = uniform(&random, -1, 1);
        judge(&m);
        expect_of_matrix(clamped_sign(&m) != TF_UNKNOWN,
                         "The sign is not known", &m);
    }
}
END_TEST

START_TEST(signs_and_bounds_hold_on_hard_matrices)
{
    generator random = generator_new(2);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_any(&random, 1 + below(&random, TF_AXES));
        matrix_nudge(&random, &m, below(&random, 4));
        judge(&m);
    }
}
END_TEST

/// A matrix close to singular, scaled so that some products of entries are
/// about 2^exponent.
static matrix scaled(generator *random, int n, int exponent)
{
    matrix m =
        below(random, 2) ? matrix_flat(random, n) : matrix_singular(random, n);
    int factors = n == 3 ? 2 + below(random, 2) : n;
    for (int j = 0; j < n; j++) {
        int own = exponent / factors + below(random, 40) - 20;
        // With two factors, the third column is as large or small as it likes.
        matrix_scale(&m, j, j < factors ? own : below(random, 1800) - 900);
    }
    matrix_nudge(random, &m, below(random, 3));
    return m;
}

START_TEST(signs_and_bounds_hold_where_products_underflow)
{
    generator random = generator_new(3);
    long count = cases(40000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = scaled(&random, n, -1080 + below(&random, 80));
        judge(&m);
    }
}
END_TEST

START_TEST(signs_hold_where_products_overflow)
{
    generator random = generator_new(4);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = scaled(&random, n, 980 + below(&random, 60));
        judge(&m);
    }
}
END_TEST

START_TEST(overflow_is_unknown)
{
    static const double huge[][4] = {{DBL_MAX, 1, -1, DBL_MAX},
                                     {0x1p512, 1, 1, 0x1p512},
                                     {DBL_MAX, DBL_MAX, DBL_MAX, -DBL_MAX},
                                     {0x1p600, 0x1p600, 0x1p600, 0x1p600}};
    for (int i = 0; i < (int)(sizeof huge / sizeof *huge); i++) {
        matrix m = matrix_of(2, huge[i]);
        judge(&m);
        expect_of_matrix(clamped_sign(&m) == TF_UNKNOWN,
                         "The sign is known despite overflow", &m);
    }
    // But a single difference keeps its sign.
    matrix m = matrix_of(1, (double[]){DBL_MAX});
    m.from[0].x[0] = -DBL_MAX;
    expect_of_matrix(clamped_sign(&m) == TF_POSITIVE,
                     "The sign of an overflowing difference is wrong", &m);
}
END_TEST

START_TEST(an_empty_matrix_breaks_the_contract)
{
    tf_differences nothing = {.n = 0};
    tf_differences_estimate(&nothing);
}
END_TEST

// Zeros -----------------------------------------------------------------------

/// Random entries of about 2^exponent where `pattern` has a bit, zeros
/// elsewhere: a determinant that is zero just if each of its terms is.
static matrix patterned(generator *random, int n, int pattern, int exponent)
{
    double entry[TF_AXES * TF_AXES] = {0};
    for (int k = 0; k < n * n; k++)
        if (pattern & 1 << k)
            entry[k] = ldexp(uniform(random, 1, 2), exponent);
    return matrix_of(n, entry);
}

static void expect_certain_zeros(generator *random, int exponent,
                                 tf_sign otherwise)
{
    for (int n = 1; n <= TF_AXES; n++)
        for (int pattern = 0; pattern < 1 << n * n; pattern++) {
            matrix m = patterned(random, n, pattern, exponent);
            judge(&m);
            bool zero = true_sign(&m) == TF_ZERO;
            tf_sign expected = zero                     ? TF_ZERO
                               : n == 1                 ? TF_POSITIVE
                               : otherwise < TF_UNKNOWN ? true_sign(&m)
                                                        : otherwise;
            expect_of_matrix(clamped_sign(&m) == expected,
                             "A zero is not told from an unknown", &m);
        }
}

START_TEST(a_zero_in_each_term_is_certified)
{
    generator random = generator_new(5);
    static const int exponents[] = {0, -150, -300, 150, 300};
    for (int i = 0; i < 5; i++)
        expect_certain_zeros(&random, exponents[i], TF_ZERO);
}
END_TEST

START_TEST(a_zero_made_by_underflow_is_not_certified)
{
    generator random = generator_new(6);
    static const int exponents[] = {-538, -600, -700, -1000, -1022};
    for (int i = 0; i < 5; i++)
        expect_certain_zeros(&random, exponents[i], TF_UNKNOWN);
}
END_TEST

START_TEST(a_zero_made_by_cancelling_is_not_certified)
{
    static const double cancelling[][9] = {
        {1, 1, 0, 1, 1, 0, 0, 0, 1},
        {1, 1, 1, 1, 1, 1, 1, 1, 1},
        {1, 2, 3, 4, 5, 6, 7, 8, 9},
        {0x1p-300, 0x1p-300, 0, 0x1p-300, 0x1p-300, 0, 0, 0, 1}};
    for (int i = 0; i < (int)(sizeof cancelling / sizeof *cancelling); i++) {
        matrix m = matrix_of(3, cancelling[i]);
        judge(&m);
        expect_of_matrix(clamped_sign(&m) == TF_UNKNOWN,
                         "The sign is known despite cancelling", &m);
    }
}
END_TEST

// Bounds ----------------------------------------------------------------------

/// The error but for the last addition, at least, as a share of the bound.
static double share(const matrix *m)
{
    judged j;
    judged_init(&j, m);
    expect_of_matrix(bound_is_kept(&j), "The error is beyond the bound", m);
    expect_of_matrix(radius_is_kept(&j), "The error is beyond the radius", m);
    sum_add(j.error, -last_place(j.estimate.number), 0.5, 1);
    long exponent;
    double error = mpz_get_d_2exp(&exponent, j.error);
    judged_clear(&j);
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

// The report's rule -----------------------------------------------------------

START_TEST(the_report_takes_four_unknown_signs_for_zeros)
{
    // Three vertices of a tetrahedron around the origin at t = 0, one at t = 1.
    static const double vertex[4][TF_AXES] = {
        {0x1.39adc5cd900e1p-2, -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2},
        {-0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2},
        {-0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4, 0x1.725a4884d51d7p-2},
        {0x1.31d6b0a9f41e9p-2, -0x1.b4c2778e24ec8p-5, -0x1.1f9303fc4c4acp-2}};
    tf_sign inside = TF_UNKNOWN;
    for (int left_out = 0; left_out < 4; left_out++) {
        double entry[TF_AXES * TF_AXES];
        for (int i = 0, row = 0; i < 4; i++)
            for (int k = 0; i != left_out && k < TF_AXES; k++)
                entry[row++] = vertex[i][k];
        matrix m = matrix_of(3, entry);
        judge(&m); // the report's sign is zero where clamped's is unknown
        expect_of_matrix(clamped_sign(&m) == TF_UNKNOWN, "The sign is known",
                         &m);
        // The origin is inside: the signs alternate.
        tf_sign sign = true_sign(&m);
        expect_of_matrix(sign != TF_ZERO && sign != inside,
                         "The origin is not inside", &m);
        inside = sign;
    }
}
END_TEST

START_TEST(clamped_arithmetics_hold_all_doubles)
{
    for (int axes = 2; axes <= TF_AXES; axes++) {
        ck_assert_int_eq(tf_clamped.bits[axes], 0);
        ck_assert_int_eq(tf_report.bits[axes], 0);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *clamped = suite_create("clamped");
    TCase *signs = tcase_create("signs");
    tcase_add_test(signs, small_integers_are_known);
    tcase_add_test(signs, random_numbers_are_known);
    tcase_add_test(signs, signs_and_bounds_hold_on_hard_matrices);
    tcase_add_test(signs, signs_and_bounds_hold_where_products_underflow);
    tcase_add_test(signs, signs_hold_where_products_overflow);
    tcase_add_test(signs, overflow_is_unknown);
    tcase_add_test(signs, clamped_arithmetics_hold_all_doubles);
    tcase_add_test_raise_signal(signs, an_empty_matrix_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(clamped, signs);
    TCase *zeros = tcase_create("zeros");
    tcase_add_test(zeros, a_zero_in_each_term_is_certified);
    tcase_add_test(zeros, a_zero_made_by_underflow_is_not_certified);
    tcase_add_test(zeros, a_zero_made_by_cancelling_is_not_certified);
    suite_add_tcase(clamped, zeros);
    TCase *bounds = tcase_create("bounds");
    tcase_add_test(bounds, bounds_are_not_much_more_than_the_worst_error);
    suite_add_tcase(clamped, bounds);
    TCase *report = tcase_create("the report's rule");
    tcase_add_test(report, the_report_takes_four_unknown_signs_for_zeros);
    suite_add_tcase(clamped, report);
    return clamped;
}
