#include "support/exactness.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "support/matrices.h"
#include "support/rational.h"

#include <float.h>
#include <math.h>

static const tf_arithmetic *tried;

void exactness_use(const tf_arithmetic *arithmetic)
{
    tried = arithmetic;
}

void expect_exact(const tf_arithmetic *arithmetic, const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    expect_of_matrix(arithmetic->sign(&differences) ==
                         oracle_arithmetic.sign(&differences),
                     "The sign is wrong", m);

    mpz_t determinant;
    mpz_init(determinant);
    int exponent = rational_determinant(determinant, &differences);
    expect_of_matrix(
        rational_is(determinant, exponent, arithmetic->value(&differences)),
        "The value is not the determinant rounded to nearest", m);
    mpz_clear(determinant);
}

static void judge(const matrix *m)
{
    expect_exact(tried, m);
}

static bool clamped_knows(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    return tf_clamped.sign(&differences) != TF_UNKNOWN;
}

// Sizes of all kinds ----------------------------------------------------------

START_TEST(all_small_matrices_are_exact)
{
    for (int n = 1; n <= TF_AXES; n++) {
        double entry[TF_AXES * TF_AXES] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
        do {
            matrix m = matrix_of(n, entry);
            judge(&m);
        } while (next_signs(n * n, entry));
    }
}
END_TEST

START_TEST(lattice_matrices_are_exact)
{
    generator random = generator_new(1);
    long count = cases(50000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_lattice(&random, 1 + below(&random, TF_AXES),
                                  2 + below(&random, 4));
        judge(&m);
    }
}
END_TEST

START_TEST(matrices_of_all_finite_doubles_are_exact)
{
    generator random = generator_new(2);
    long count = cases(100000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_bits(&random, 1 + below(&random, TF_AXES));
        judge(&m);
    }
}
END_TEST

START_TEST(matrices_of_extreme_magnitudes_are_exact)
{
    generator random = generator_new(3);
    long count = cases(50000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_extreme(&random, 1 + below(&random, TF_AXES));
        judge(&m);
        matrix_nudge(&random, &m, 1);
        judge(&m);
    }
}
END_TEST

// Next to zero ----------------------------------------------------------------

/// Leave the minuends alone, so that every difference is a double.
static void clear_subtrahends(matrix *m)
{
    for (int i = 1; i < matrix_size(m); i += 2)
        *matrix_coordinate(m, i) = 0;
}

/// Scale each column to within what a double holds, often so that products are
/// within it, too.
static void scale_at_random(generator *random, matrix *m)
{
    int range = below(random, 2) ? 200 : 900;
    for (int j = 0; j < m->n; j++)
        matrix_scale(m, j, below(random, 2 * range) - range);
}

START_TEST(singular_matrices_and_their_neighbors_are_exact)
{
    generator random = generator_new(4);
    long count = cases(30000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_singular(&random, 2 + below(&random, 2));
        if (below(&random, 2))
            clear_subtrahends(&m);
        scale_at_random(&random, &m);
        tf_differences differences = matrix_differences(&m);
        judge(&m);
        expect_of_matrix(tried->sign(&differences) == TF_ZERO,
                         "The sign is not zero", &m);
        double *x = matrix_coordinate(&m, below(&random, matrix_size(&m)));
        *x = nextafter(*x, below(&random, 2) ? DBL_MAX : -DBL_MAX);
        judge(&m);
    }
}
END_TEST

START_TEST(rounded_singular_matrices_are_exact)
{
    generator random = generator_new(5);
    long count = cases(50000), unknown = 0;
    for (long i = 0; i < count; i++) {
        matrix m = matrix_flat(&random, 2 + below(&random, 2));
        if (below(&random, 2))
            clear_subtrahends(&m);
        if (below(&random, 2))
            scale_at_random(&random, &m);
        matrix_nudge(&random, &m, below(&random, 2));
        judge(&m);
        unknown += !clamped_knows(&m);
    }
    // Those are what the superaccumulator is for.
    ck_assert_msg(5 * unknown > count, "Only %ld of %ld are close", unknown,
                  count);
}
END_TEST

// Products out of range -------------------------------------------------------

START_TEST(products_out_of_range_are_exact)
{
    // Products of three stay in range, or just overflow or do not, lose places
    // or do not.
    static const double ends[] = {
        0x1.fffffffffffffp-301, 0x1p-300, 0x1.0000000000001p-300,
        0x1.fffffffffffffp299,  0x1p300,  0x1.0000000000001p300,
        0x1.fffffffffffffp-306, 0x1p-305, 0x1.0000000000001p-305,
        0x1.fffffffffffffp340,  0x1p341,  0x1.0000000000001p341};
    generator random = generator_new(6);
    long count = cases(30000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 2 + below(&random, 2));
        for (int k = 0; k < matrix_size(&m); k += 2) {
            double x = ends[below(&random, 12)];
            *matrix_coordinate(&m, k) = below(&random, 2) ? x : -x;
        }
        judge(&m);
    }
}
END_TEST

START_TEST(singular_matrices_with_products_out_of_range_are_exact)
{
    // Products of three overflow from 2^341 on, and lose places below 2^-305.
    generator random = generator_new(10);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = below(&random, 2) ? matrix_flat(&random, n)
                                     : matrix_singular(&random, n);
        clear_subtrahends(&m);
        int exponent =
            (below(&random, 2) ? 1 : -1) * (280 + below(&random, 300));
        for (int j = 0; j < n; j++)
            matrix_scale(&m, j, exponent + below(&random, 20));
        judge(&m);
    }
}
END_TEST

START_TEST(roundoff_of_differences_decides_the_sign)
{
    // All rounded differences are 1, so that only what they lose tells.
    generator random = generator_new(7);
    long count = cases(30000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 2 + below(&random, 2));
        for (int k = 0; k < matrix_size(&m); k += 2) {
            *matrix_coordinate(&m, k) = 1;
            *matrix_coordinate(&m, k + 1) =
                ldexp(below(&random, 5) - 2, -56 - below(&random, 2) * 1000);
        }
        judge(&m);
    }
}
END_TEST

START_TEST(differences_that_overflow_are_exact)
{
    // Of 0x1.8p971 and DBL_MAX the sum is finite, but a step to its roundoff
    // is not.
    static const double huge[] = {
        DBL_MAX, 0x1.8p971, 0x1p1023, 0x1p1022, 0x1.fffffffffffffp1021,
        0x1p970, 0x1.8p969, 1,        0};
    generator random = generator_new(8);
    long count = cases(50000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 1 + below(&random, TF_AXES));
        int sizes = 1 + below(&random, 9);
        for (int k = 0; k < matrix_size(&m); k++) {
            double x = huge[below(&random, sizes)];
            *matrix_coordinate(&m, k) = below(&random, 2) ? x : -x;
        }
        judge(&m);
    }
}
END_TEST

START_TEST(products_that_underflow_keep_their_sign)
{
    // Products of entries far below the least double, singular or nearly.
    generator random = generator_new(9);
    long count = cases(30000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = matrix_lattice(&random, n, 4);
        for (int j = 0; j < n; j++)
            matrix_scale(&m, j, -1074 + below(&random, 3));
        judge(&m);
        matrix_nudge(&random, &m, 1);
        judge(&m);
    }
}
END_TEST

static TCase *case_with(const char *name, void (*use)(void))
{
    TCase *c = tcase_create(name);
    tcase_add_checked_fixture(c, use, NULL);
    return c;
}

void exactness_add(Suite *suite, void (*use)(void))
{
    TCase *sizes = case_with("all sizes", use);
    tcase_add_test(sizes, all_small_matrices_are_exact);
    tcase_add_test(sizes, lattice_matrices_are_exact);
    tcase_add_test(sizes, matrices_of_all_finite_doubles_are_exact);
    tcase_add_test(sizes, matrices_of_extreme_magnitudes_are_exact);
    suite_add_tcase(suite, sizes);
    TCase *zero = case_with("next to zero", use);
    tcase_add_test(zero, singular_matrices_and_their_neighbors_are_exact);
    tcase_add_test(zero, rounded_singular_matrices_are_exact);
    suite_add_tcase(suite, zero);
    TCase *range = case_with("out of range", use);
    tcase_add_test(range, products_out_of_range_are_exact);
    tcase_add_test(range,
                   singular_matrices_with_products_out_of_range_are_exact);
    tcase_add_test(range, roundoff_of_differences_decides_the_sign);
    tcase_add_test(range, differences_that_overflow_are_exact);
    tcase_add_test(range, products_that_underflow_keep_their_sign);
    suite_add_tcase(suite, range);
}
