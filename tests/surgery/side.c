// Sides and turns, against rational numbers.
#include "surgery/side.h"

#include "support/support.h"

#include <float.h>
#include <gmp.h>
#include <math.h>

/// The sign of the determinant of point[i] - point[0] on n axes; n = 2 or 3.
static int exact_sign(int n, const int axis[], double point[][3])
{
    mpq_t d[3][3], sum, term;
    mpq_inits(sum, term, NULL);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            mpq_init(d[i][k]);
            mpq_set_si(d[i][k], i == k, 1);
            if (i >= n || k >= n)
                continue;
            mpq_set_d(d[i][k], point[i + 1][axis[k]]);
            mpq_set_d(term, point[0][axis[k]]);
            mpq_sub(d[i][k], d[i][k], term);
        }
    for (int k = 0; k < 6; k++) {
        int a = k % 3, b = (a + 1 + k / 3) % 3, c = 3 - a - b;
        mpq_mul(term, d[0][a], d[1][b]);
        mpq_mul(term, term, d[2][c]);
        (k < 3 ? mpq_add : mpq_sub)(sum, sum, term);
    }
    int sign = mpq_sgn(sum);
    for (int i = 0; i < 9; i++)
        mpq_clear(d[i / 3][i % 3]);
    mpq_clears(sum, term, NULL);
    return sign;
}

static double some_number(generator *random, int way)
{
    switch (way) {
    case 0:
        return below(random, 4);
    case 1: // near the lattice
        return below(random, 3) + (below(random, 3) - 1) * DBL_EPSILON;
    case 2:
        return ldexp(uniform(random, -1, 1), below(random, 40) - 20);
    default: // of all sizes
        return ldexp(uniform(random, -1, 1), below(random, 2090) - 1070);
    }
}

START_TEST(sides_are_exact)
{
    static const int space[] = {0, 1, 2};
    generator random = generator_new(1 + (uint64_t)_i);
    int zeros = 0;
    for (long i = 0; i < cases(5000); i++) {
        double x[4][3];
        for (int j = 0; j < 12; j++)
            x[j / 3][j % 3] = some_number(&random, _i);
        int sign = exact_sign(3, space, x);
        ck_assert_int_eq(tf_side(x[0], x[1], x[2], x[3]), sign);
        ck_assert_int_eq(tf_side(x[0], x[2], x[1], x[3]), -sign);
        zeros += sign == 0;
    }
    ck_assert(_i > 1 || zeros > 0);
}
END_TEST

START_TEST(turns_are_exact)
{
    generator random = generator_new(11 + (uint64_t)_i);
    for (long i = 0; i < cases(5000); i++) {
        double x[3][3];
        bool collinear = true;
        for (int j = 0; j < 9; j++)
            x[j / 3][j % 3] = some_number(&random, _i);
        for (int j = 0; j < 3; j++) {
            int sign = exact_sign(2, tf_planes[j], x);
            ck_assert_int_eq(tf_turn(tf_planes[j], x[0], x[1], x[2]), sign);
            collinear = collinear && sign == 0;
        }
        ck_assert(tf_are_collinear(x[0], x[1], x[2]) == collinear);
    }
}
END_TEST

START_TEST(only_points_on_a_line_are_collinear)
{
    const double a[] = {1, 2, 3}, b[] = {2, 4, 5}, c[] = {4, 8, 9};
    const double d[] = {4, 8, 9 + 0x1p-49};
    ck_assert(tf_are_collinear(a, b, c));
    ck_assert(!tf_are_collinear(a, b, d));
    ck_assert(tf_are_collinear(a, a, d));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/side");
    TCase *tcase = tcase_create("signs");
    tcase_add_loop_test(tcase, sides_are_exact, 0, 4);
    tcase_add_loop_test(tcase, turns_are_exact, 0, 4);
    tcase_add_test(tcase, only_points_on_a_line_are_collinear);
    suite_add_tcase(suite, tcase);
    return suite;
}
