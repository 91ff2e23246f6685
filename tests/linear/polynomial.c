#include "linear/polynomial.h"

#include "support/support.h"

#include <math.h>
#include <stdbool.h>

// The cubic a (t - r0) (t - r1) (t - r2), or the quadratic of two roots.

static tf_polynomial with_roots(int degree, double a, const double r[])
{
    if (degree == 2)
        return (tf_polynomial){
            .degree = 2,
            .coefficient = {a * r[0] * r[1],
                            -a * ((1 - r[0]) * r[1] + (1 - r[1]) * r[0]) / 2,
                            a * (1 - r[0]) * (1 - r[1])}};
    tf_polynomial p = {.degree = 3};
    for (int late = 0; late < 8; late++) {
        double product = a;
        int count = 0;
        for (int i = 0; i < 3; i++) {
            product *= late >> i & 1 ? 1 - r[i] : -r[i];
            count += late >> i & 1;
        }
        p.coefficient[count] += count % 3 == 0 ? product : product / 3;
    }
    return p;
}

/// All roots in [0, 1].
static int roots_of(const tf_polynomial *p, double root[])
{
    double cut[TF_MOST_CUTS];
    int count = 0, cuts = tf_polynomial_cuts(p, cut);
    for (int i = 0; i + 1 < cuts; i++)
        if (tf_polynomial_value(p, cut[i]) *
                tf_polynomial_value(p, cut[i + 1]) <
            0)
            root[count++] = tf_polynomial_root(p, cut[i], cut[i + 1]);
    return count;
}

START_TEST(values_are_those_of_the_product)
{
    generator random = generator_new(1);
    for (int i = 0; i < 1000; i++) {
        int degree = 2 + i % 2;
        double r[3], t = uniform(&random, 0, 1), product = 3;
        for (int k = 0; k < 3; k++)
            r[k] = uniform(&random, -1, 2);
        for (int k = 0; k < degree; k++)
            product *= t - r[k];
        tf_polynomial p = with_roots(degree, 3, r);
        ck_assert_double_eq_tol(tf_polynomial_value(&p, t), product, 1e-13);
    }
}
END_TEST

START_TEST(separate_roots_are_found)
{
    generator random = generator_new(2);
    for (long i = 0; i < cases(20000); i++) {
        int degree = 2 + (int)(i % 2), expected = 0;
        double r[3], found[3];
        for (int k = 0; k < 3; k++)
            r[k] = k + (k == 0 ? uniform(&random, -1, 0.9)
                               : uniform(&random, 0.1, 0.9));
        double scale = ldexp(below(&random, 2) ? 1 : -1, below(&random, 99));
        for (int k = 0; k < degree; k++)
            r[k] = r[k] / 2;
        tf_polynomial p = with_roots(degree, scale, r);
        int count = roots_of(&p, found);
        for (int k = 0; k < degree; k++) {
            if (r[k] <= 0 || r[k] >= 1)
                continue;
            ck_assert_int_lt(expected, count);
            ck_assert_double_eq_tol(found[expected++], r[k], 1e-13);
        }
        ck_assert_int_eq(expected, count);
    }
}
END_TEST

START_TEST(multiple_roots_end_the_iteration)
{
    // A triple root, and one that two others almost meet.
    double root[3];
    tf_polynomial triple = with_roots(3, 1, (double[]){0.3, 0.3, 0.3});
    ck_assert_int_eq(roots_of(&triple, root), 1);
    ck_assert_double_eq_tol(root[0], 0.3, 1e-5);
    tf_polynomial close = with_roots(3, 1, (double[]){0.6, 0.6, 0.25});
    ck_assert_int_ge(roots_of(&close, root), 1);
    ck_assert_double_eq_tol(root[0], 0.25, 1e-14);
}
END_TEST

START_TEST(cuts_are_in_order)
{
    generator random = generator_new(3);
    static const double odd[] = {0, -0.0, 1, -1, 1e-320, 1e300, -1e300};
    for (long i = 0; i < cases(20000); i++) {
        tf_polynomial p = {.degree = 2 + (int)(i % 2)};
        for (int k = 0; k <= p.degree; k++)
            p.coefficient[k] = odd[below(&random, 7)];
        double cut[TF_MOST_CUTS];
        int count = tf_polynomial_cuts(&p, cut);
        ck_assert_int_ge(count, 2);
        ck_assert_int_le(count, p.degree + 1);
        ck_assert(cut[0] == 0 && cut[count - 1] == 1);
        for (int k = 1; k < count; k++)
            ck_assert_double_le(cut[k - 1], cut[k]);
    }
}
END_TEST

START_TEST(extrema_are_cuts)
{
    // t (t - 1/2) (t - 1) has them at 1/2 -+ sqrt(1/12).
    tf_polynomial p = with_roots(3, 5, (double[]){0, 0.5, 1});
    double cut[TF_MOST_CUTS];
    ck_assert_int_eq(tf_polynomial_cuts(&p, cut), 4);
    ck_assert_double_eq_tol(cut[1], 0.5 - sqrt(1.0 / 12), 1e-15);
    ck_assert_double_eq_tol(cut[2], 0.5 + sqrt(1.0 / 12), 1e-15);
}
END_TEST

START_TEST(small_extrema_do_not_cancel)
{
    // The derivative is 3 times 1e-17 (1 - t)^2 - 2 (1 - t) t - t^2.
    tf_polynomial p = {.degree = 3, .coefficient = {0, 1e-17, -1, -2}};
    double cut[TF_MOST_CUTS];
    ck_assert_int_eq(tf_polynomial_cuts(&p, cut), 3);
    ck_assert_double_eq_tol(cut[1], 5e-18, 1e-32);
}
END_TEST

START_TEST(coefficients_bound_the_values)
{
    tf_polynomial p = {.degree = 3, .coefficient = {1, 2, 3, 4}};
    ck_assert(!tf_polynomial_can_reach(&p, 0.5));
    ck_assert(tf_polynomial_can_reach(&p, 1));
    p.coefficient[2] = -0.25;
    ck_assert(tf_polynomial_can_reach(&p, 0));
    ck_assert(!tf_polynomial_is_zero(&p));
    ck_assert(tf_polynomial_is_zero(
        &(tf_polynomial){.degree = 2, .coefficient = {0, -0.0, 0, 1}}));
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/polynomial");
    TCase *c = tcase_create("polynomials");
    tcase_add_test(c, values_are_those_of_the_product);
    tcase_add_test(c, separate_roots_are_found);
    tcase_add_test(c, multiple_roots_end_the_iteration);
    tcase_add_test(c, cuts_are_in_order);
    tcase_add_test(c, extrema_are_cuts);
    tcase_add_test(c, small_extrema_do_not_cancel);
    tcase_add_test(c, coefficients_bound_the_values);
    suite_add_tcase(s, c);
    return s;
}
