#include "arithmetic/integer.h"

#include "arithmetic/functions.h"
#include "query/query.h"
#include "support/exactness.h"
#include "support/rational.h"

#include <float.h>
#include <math.h>

static const tf_arithmetic *const both[] = {&tf_integer64, &tf_integer128};

/// The largest coordinate that an arithmetic takes where there are n x n
/// determinants: a 1x1 one is of the plane.
static double largest_coordinate(const tf_arithmetic *arithmetic, int n)
{
    return ldexp(1, arithmetic->bits[n == 3 ? 3 : 2]) - 1;
}

// The ends of the range -------------------------------------------------------

/// Each coordinate least, zero or largest.
static void judge_all_coordinates(const tf_arithmetic *arithmetic, int n)
{
    double end[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
    generator random = generator_new(1);
    do {
        matrix m = matrix_new(&random, n);
        for (int i = 0; i < matrix_size(&m); i++)
            *matrix_coordinate(&m, i) =
                end[i] * largest_coordinate(arithmetic, n);
        expect_exact(arithmetic, &m);
    } while (next_signs(2 * n * n, end));
}

START_TEST(signs_and_values_are_exact_at_the_ends_of_the_range)
{
    const tf_arithmetic *arithmetic = both[_i];
    judge_all_coordinates(arithmetic, 1);
    judge_all_coordinates(arithmetic, 2);
}
END_TEST

START_TEST(the_largest_differences_have_exact_signs_and_values)
{
    const tf_arithmetic *arithmetic = both[_i];
    double end[9] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
    generator random = generator_new(2);
    double size = largest_coordinate(arithmetic, 3);
    do {
        matrix m = matrix_new(&random, 3);
        for (int k = 0; k < 9; k++) {
            *matrix_coordinate(&m, 2 * k) = end[k] * size;
            *matrix_coordinate(&m, 2 * k + 1) = -end[k] * size;
        }
        expect_exact(arithmetic, &m);
    } while (next_signs(9, end));
}
END_TEST

/// A coordinate from the whole range, its ends and zero above all.
static double any_coordinate(generator *random, double size)
{
    switch (below(random, 4)) {
    case 0:
        return (below(random, 3) - 1) * size;
    case 1:
        return (below(random, 2) ? 1 : -1) * (size - below(random, 3));
    case 2:
        return below(random, 3) - 1;
    default:
        return trunc(uniform(random, -size, size));
    }
}

START_TEST(signs_and_values_of_random_integers_are_exact)
{
    const tf_arithmetic *arithmetic = both[_i];
    generator random = generator_new(3);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 1 + below(&random, TF_AXES));
        double size = largest_coordinate(arithmetic, m.n);
        bool ends = below(&random, 2);
        for (int k = 0; k < matrix_size(&m); k++)
            *matrix_coordinate(&m, k) = ends ? (below(&random, 3) - 1) * size
                                             : any_coordinate(&random, size);
        expect_exact(arithmetic, &m);
    }
}
END_TEST

START_TEST(signs_and_values_near_singular_matrices_are_exact)
{
    const tf_arithmetic *arithmetic = both[_i];
    generator random = generator_new(4);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = matrix_new(&random, n);
        double size = largest_coordinate(arithmetic, n);
        // The last row is plus or minus the first.
        double sign = below(&random, 2) ? 1 : -1;
        int row = 2 * n, last = row * (n - 1);
        for (int k = 0; k < last; k++)
            *matrix_coordinate(&m, k) = any_coordinate(&random, size);
        for (int k = 0; k < row; k++)
            *matrix_coordinate(&m, last + k) = sign * *matrix_coordinate(&m, k);
        expect_exact(arithmetic, &m);
        *matrix_coordinate(&m, below(&random, matrix_size(&m))) =
            any_coordinate(&random, size);
        expect_exact(arithmetic, &m);
    }
}
END_TEST

// The limits ------------------------------------------------------------------

START_TEST(limits_are_as_documented)
{
    static const struct {
        const tf_arithmetic *arithmetic;
        int axes, bits;
    } limit[] = {{&tf_integer64, 3, 19},
                 {&tf_integer64, 2, 30},
                 {&tf_integer128, 3, 40},
                 {&tf_integer128, 2, 53}};
    for (int i = 0; i < (int)(sizeof limit / sizeof *limit); i++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double beyond = sign * ldexp(1, limit[i].bits),
                   last = beyond - sign;
            const tf_arithmetic *arithmetic = limit[i].arithmetic;
            int axes = limit[i].axes;
            ck_assert_msg(tf_arithmetic_holds(arithmetic, axes, last),
                          "%s, %d axes: %a is not held", arithmetic->name, axes,
                          last);
            ck_assert_msg(!tf_arithmetic_holds(arithmetic, axes, beyond),
                          "%s, %d axes: %a is held", arithmetic->name, axes,
                          beyond);
        }
}
END_TEST

START_TEST(only_integers_are_held)
{
    static const double others[] = {
        0.5, -0x1.fffffffffffffp17, DBL_TRUE_MIN, -DBL_MIN, INFINITY, NAN};
    for (int axes = 2; axes <= 3; axes++)
        for (int i = 0; i < (int)(sizeof others / sizeof *others); i++) {
            ck_assert_msg(!tf_arithmetic_holds(both[_i], axes, others[i]),
                          "%s, %d axes: %a is held", both[_i]->name, axes,
                          others[i]);
        }
}
END_TEST

// Why the limits are where they are -------------------------------------------

/// The bits of an integer of an arithmetic, without the sign.
static size_t room(const tf_arithmetic *arithmetic)
{
    return arithmetic == &tf_integer64 ? 63 : 127;
}

static size_t bits_of(const mpz_t integer)
{
    return mpz_sizeinbase(integer, 2);
}

static void find_determinant(mpz_t determinant, const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    int exponent = rational_determinant(determinant, &differences);
    mpz_mul_2exp(determinant, determinant, (mp_bitcnt_t)exponent);
}

/// The largest determinant of differences of integers up to `most`.  It is
/// linear in each difference, so those of opposite ends are enough.
static void find_largest(mpz_t largest, int n, double most)
{
    double end[9] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
    generator random = generator_new(5);
    mpz_t own;
    mpz_init(own);
    mpz_set_ui(largest, 0);
    do {
        matrix m = matrix_new(&random, n);
        for (int k = 0; k < n * n; k++) {
            *matrix_coordinate(&m, 2 * k) = end[k] * most;
            *matrix_coordinate(&m, 2 * k + 1) = -end[k] * most;
        }
        find_determinant(own, &m);
        if (mpz_cmp(own, largest) > 0)
            mpz_set(largest, own);
    } while (next_signs(n * n, end));
    mpz_clear(own);
}

START_TEST(the_largest_determinant_fits)
{
    mpz_t largest, expected;
    mpz_inits(largest, expected, NULL);
    for (int n = 2; n <= 3; n++) {
        // 2 m^2 and 4 m^3 with m, the largest difference.
        double most = largest_coordinate(both[_i], n);
        find_largest(largest, n, most);
        mpz_set_d(expected, 2 * most);
        mpz_pow_ui(expected, expected, (unsigned long)n);
        mpz_mul_ui(expected, expected, n == 2 ? 2 : 4);
        ck_assert_msg(mpz_cmp(largest, expected) == 0, "%d x %d", n, n);
        ck_assert_msg(bits_of(largest) <= room(both[_i]), "%d x %d: %zu bits",
                      n, n, bits_of(largest));
    }
    mpz_clears(largest, expected, NULL);
}
END_TEST

START_TEST(a_determinant_of_one_bit_more_overflows)
{
    // Two rows from one corner of a cube, and one along a diagonal: three
    // events at one time and two at the other, as queries have them.
    static const double to[9] = {1, 1, -1, 1, -1, 1, 1, -1, -1};
    static const double from[9] = {-1, -1, -1, -1, -1, -1, -1, 1, 1};
    generator random = generator_new(6);
    double most = ldexp(1, both[_i]->bits[3] + 1) - 1;
    matrix m = matrix_new(&random, 3);
    for (int k = 0; k < 9; k++) {
        *matrix_coordinate(&m, 2 * k) = to[k] * most;
        *matrix_coordinate(&m, 2 * k + 1) = from[k] * most;
    }
    mpz_t determinant;
    mpz_init(determinant);
    find_determinant(determinant, &m);
    ck_assert_msg(bits_of(determinant) > room(both[_i]), "%zu bits",
                  bits_of(determinant));
    mpz_clear(determinant);
}
END_TEST

/// What 64 bits keep of the determinant: its rest modulo 2^64, from -2^63 to
/// 2^63 - 1.
static tf_sign wrapped_sign(const tf_differences *differences)
{
    mpz_t rest;
    mpz_init(rest);
    int exponent = rational_determinant(rest, differences);
    mpz_mul_2exp(rest, rest, (mp_bitcnt_t)exponent);
    mpz_fdiv_r_2exp(rest, rest, 64);
    int sign = mpz_tstbit(rest, 63) ? -1 : mpz_sgn(rest);
    mpz_clear(rest);
    return (tf_sign)sign;
}

/// Let a point fly through a cube from corner to corner, across the triangle of
/// three other corners.
static tf_status query_the_cube(const tf_arithmetic *arithmetic, int bits,
                                tf_contact *contact)
{
    double m = ldexp(1, bits) - 1;
    double start[] = {m, m, m}, end[] = {-m, -m, -m};
    double corner[3][3] = {{m, -m, -m}, {-m, m, -m}, {-m, -m, m}};
    tf_worldline point = tf_worldline_between(3, start, end), triangle[3];
    for (int i = 0; i < 3; i++)
        triangle[i] = tf_worldline_between(3, corner[i], corner[i]);
    return tf_query(arithmetic, 3, 1, &point, 3, triangle, contact);
}

static tf_verdict cross_the_cube(const tf_arithmetic *arithmetic, int bits)
{
    tf_contact contact;
    ck_assert_int_eq(query_the_cube(arithmetic, bits, &contact), TF_OK);
    return contact.verdict;
}

START_TEST(coordinates_of_20_bits_would_miss_a_contact)
{
    // Integers of 64 bits that go around, and no check of the range.
    tf_arithmetic wrapping = oracle_arithmetic;
    wrapping.sign = wrapped_sign;
    ck_assert_int_eq(cross_the_cube(&tf_integer64, 19), TF_HIT);
    ck_assert_int_eq(cross_the_cube(&wrapping, 19), TF_HIT);
    ck_assert_int_eq(cross_the_cube(&wrapping, 20), TF_APART);
    ck_assert_int_eq(cross_the_cube(&tf_integer128, 20), TF_HIT);

    tf_contact none;
    ck_assert_int_eq(query_the_cube(&tf_integer64, 20, &none), TF_OUT_OF_RANGE);
}
END_TEST

Suite *suite(void)
{
    Suite *integer = suite_create("integer");
    TCase *signs = tcase_create("signs and values");
    tcase_add_loop_test(
        signs, signs_and_values_are_exact_at_the_ends_of_the_range, 0, 2);
    tcase_add_loop_test(
        signs, the_largest_differences_have_exact_signs_and_values, 0, 2);
    tcase_add_loop_test(signs, signs_and_values_of_random_integers_are_exact, 0,
                        2);
    tcase_add_loop_test(
        signs, signs_and_values_near_singular_matrices_are_exact, 0, 2);
    suite_add_tcase(integer, signs);
    TCase *limits = tcase_create("limits");
    tcase_add_test(limits, limits_are_as_documented);
    tcase_add_loop_test(limits, only_integers_are_held, 0, 2);
    suite_add_tcase(integer, limits);
    TCase *reasons = tcase_create("reasons for the limits");
    tcase_add_loop_test(reasons, the_largest_determinant_fits, 0, 2);
    tcase_add_loop_test(reasons, a_determinant_of_one_bit_more_overflows, 0, 2);
    tcase_add_test(reasons, coordinates_of_20_bits_would_miss_a_contact);
    suite_add_tcase(integer, reasons);
    return integer;
}
