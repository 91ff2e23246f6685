#include "arithmetic/superaccumulator.h"
#include "support/matrices.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST_PRODUCTS = 48
};

/// A sum of products, as the accumulator and as the oracle know it, and what it
/// is a sum of, for the failure message.
typedef struct twin {
    tf_superaccumulator accumulator;
    mpz_t sum;
    int count;
    double factor[MOST_PRODUCTS][3];
} twin;

static void twin_init(twin *both)
{
    // What was there before must not matter, nor cancel.
    memset(&both->accumulator, 0x5a, sizeof both->accumulator);
    memset(both->accumulator.sum[1], 0xa5, sizeof both->accumulator.sum[1]);
    tf_superaccumulator_clear(&both->accumulator);
    mpz_init(both->sum);
    both->count = 0;
}

static void add(twin *both, double a, double b, double c)
{
    ck_assert_int_lt(both->count, MOST_PRODUCTS);
    tf_superaccumulator_add(&both->accumulator, a, b, c);
    sum_add(both->sum, a, b, c);
    double *factor = both->factor[both->count++];
    factor[0] = a, factor[1] = b, factor[2] = c;
}

static void expect(bool good, const char *what, const twin *both)
{
    if (good)
        return;
    char text[8192];
    int length = 0;
    for (int i = 0; i < both->count; i++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "+ %a * %a * %a\n", both->factor[i][0],
                           both->factor[i][1], both->factor[i][2]);
    ck_abort_msg("%s\nseed %llu\n%s", what, (unsigned long long)seed(), text);
}

static void judge(const twin *both)
{
    expect(tf_superaccumulator_sign(&both->accumulator) == sum_sign(both->sum),
           "The sign of the sum is wrong", both);
    expect(rational_is(both->sum, SUM_EXPONENT,
                       tf_superaccumulator_value(&both->accumulator)),
           "The value is not the sum rounded to nearest", both);
}

static void judge_and_clear(twin *both)
{
    judge(both);
    mpz_clear(both->sum);
}

/// Add x 2^exponent, for an integer x.
static void add_scaled(twin *both, double x, int exponent)
{
    double power[2];
    for (int i = 0; i < 2; i++) {
        int own = exponent < -1074 ? -1074 : exponent > 1023 ? 1023 : exponent;
        power[i] = ldexp(1, own);
        exponent -= own;
    }
    add(both, ldexp(x, exponent), power[0], power[1]);
}

// Random sums -----------------------------------------------------------------

START_TEST(sums_of_all_doubles_are_exact)
{
    generator random = generator_new(1);
    long count = cases(6000);
    for (long i = 0; i < count; i++) {
        twin both;
        twin_init(&both);
        int products = 1 + below(&random, MOST_PRODUCTS);
        for (int k = 0; k < products; k++)
            add(&both, any_double(&random), any_double(&random),
                any_double(&random));
        judge_and_clear(&both);
    }
}
END_TEST

/// A factor from few magnitudes, so that products cancel and carry.
static double choose_factor(generator *random)
{
    static const double sizes[] = {0,
                                   DBL_TRUE_MIN,
                                   DBL_MIN - DBL_TRUE_MIN,
                                   DBL_MIN,
                                   1 - DBL_EPSILON / 2,
                                   1,
                                   1 + DBL_EPSILON,
                                   3,
                                   DBL_MAX};
    double x = sizes[below(random, (int)(sizeof sizes / sizeof *sizes))];
    return below(random, 2) ? -x : x;
}

START_TEST(sums_of_few_magnitudes_are_exact)
{
    generator random = generator_new(2);
    long count = cases(10000);
    for (long i = 0; i < count; i++) {
        twin both;
        twin_init(&both);
        int products = 1 + below(&random, MOST_PRODUCTS);
        for (int k = 0; k < products; k++)
            add(&both, choose_factor(&random), choose_factor(&random),
                choose_factor(&random));
        judge_and_clear(&both);
    }
}
END_TEST

START_TEST(products_cancel_to_the_last_place)
{
    generator random = generator_new(3);
    long count = cases(5000);
    for (long i = 0; i < count; i++) {
        twin both;
        twin_init(&both);
        for (int k = 0; k < (MOST_PRODUCTS - 1) / 2; k++) {
            double a = any_double(&random), b = any_double(&random),
                   c = any_double(&random);
            add(&both, a, b, c);
            // The same product, its factors in another order.
            add(&both, -c, a, b);
        }
        judge(&both);
        expect(tf_superaccumulator_sign(&both.accumulator) == TF_ZERO,
               "What cancels is not zero", &both);
        add(&both, any_double(&random), DBL_TRUE_MIN, -DBL_TRUE_MIN);
        judge_and_clear(&both);
    }
}
END_TEST

// The ends --------------------------------------------------------------------

START_TEST(an_empty_sum_is_zero)
{
    twin both;
    twin_init(&both);
    judge(&both);
    add(&both, 0, DBL_MAX, DBL_MAX);
    add(&both, -DBL_TRUE_MIN, -0.0, DBL_TRUE_MIN);
    tf_value value = tf_superaccumulator_value(&both.accumulator);
    expect(value.number == 0 && value.radius == 0, "Zeros do not make zero",
           &both);
    judge_and_clear(&both);
}
END_TEST

START_TEST(a_cleared_superaccumulator_is_zero)
{
    twin both;
    twin_init(&both);
    for (int i = 0; i < MOST_PRODUCTS; i++)
        add(&both, DBL_MAX, DBL_MAX, i % 2 ? DBL_MAX : -DBL_TRUE_MIN);
    tf_superaccumulator_clear(&both.accumulator);
    both.count = 0;
    mpz_set_ui(both.sum, 0);
    judge_and_clear(&both);
}
END_TEST

START_TEST(the_largest_and_the_smallest_sums_are_exact)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        twin large, small;
        twin_init(&large);
        twin_init(&small);
        for (int i = 0; i < MOST_PRODUCTS; i++) {
            add(&large, DBL_MAX, DBL_MAX, sign * DBL_MAX);
            add(&small, DBL_TRUE_MIN, sign * DBL_TRUE_MIN, DBL_TRUE_MIN);
            judge(&large);
            judge(&small);
        }
        mpz_clears(large.sum, small.sum, NULL);
    }
}
END_TEST

START_TEST(a_last_place_is_not_lost_beside_the_largest)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        twin both;
        twin_init(&both);
        add(&both, DBL_MAX, DBL_MAX, DBL_MAX);
        add(&both, DBL_TRUE_MIN, DBL_TRUE_MIN, sign * DBL_TRUE_MIN);
        add(&both, -DBL_MAX, DBL_MAX, DBL_MAX);
        judge_and_clear(&both);
    }
}
END_TEST

// Carries and rounding, at every position -------------------------------------

/// Lowest exponents of a 53-bit number from the unit to the top.
enum {
    LOWEST = SUM_EXPONENT,
    HIGHEST = 3 * 1023 - 53
};

START_TEST(powers_of_two_in_all_positions_are_exact)
{
    for (int exponent = LOWEST; exponent <= 3 * 1023; exponent++) {
        twin both;
        twin_init(&both);
        add_scaled(&both, exponent % 2 ? 1 : -1, exponent);
        judge_and_clear(&both);
    }
}
END_TEST

START_TEST(carries_run_through_many_words)
{
    // 46 times 53 ones, next to each other, a one that tips them over, and what
    // they make: rounding would hide a carry that gets stuck on its way.
    const int ones = 46;
    for (int exponent = LOWEST; exponent + ones * 53 <= HIGHEST;
         exponent += 61) {
        twin both;
        twin_init(&both);
        for (int i = 0; i < ones; i++)
            add_scaled(&both, 0x1p53 - 1, exponent + 53 * i);
        judge(&both);
        add_scaled(&both, 1, exponent);
        judge(&both);
        add_scaled(&both, -1, exponent + 53 * ones);
        expect(tf_superaccumulator_sign(&both.accumulator) == TF_ZERO,
               "The carry does not arrive", &both);
        judge_and_clear(&both);
    }
}
END_TEST

START_TEST(borrows_run_through_many_words)
{
    for (int exponent = LOWEST; exponent <= 3 * 1023; exponent += 7)
        for (int sign = -1; sign <= 1; sign += 2) {
            twin both;
            twin_init(&both);
            add_scaled(&both, sign, exponent);
            add_scaled(&both, -sign, SUM_EXPONENT);
            judge_and_clear(&both);
        }
}
END_TEST

/// Judge number 2^exponent + rest 2^(exponent - 1) + last 2^SUM_EXPONENT.
static void judge_rounding(double number, double rest, double last,
                           int exponent)
{
    twin both;
    twin_init(&both);
    add_scaled(&both, number, exponent);
    add_scaled(&both, rest, exponent - 1);
    add_scaled(&both, last, SUM_EXPONENT);
    judge_and_clear(&both);
}

START_TEST(values_are_rounded_to_nearest_and_ties_to_even)
{
    // Even, odd, and those whose neighbours are nearer or further.
    static const double numbers[] = {0x1p52, 0x1p52 + 1, 0x1p52 + 2, 0x1p53 - 2,
                                     0x1p53 - 1};
    for (int exponent = LOWEST + 1; exponent <= HIGHEST; exponent += 13)
        for (int i = 0; i < (int)(sizeof numbers / sizeof *numbers); i++)
            for (int rest = -1; rest <= 1; rest++)
                for (int last = -1; last <= 1; last++) {
                    judge_rounding(numbers[i], rest, last, exponent);
                    judge_rounding(-numbers[i], rest, last, exponent);
                }
}
END_TEST

START_TEST(every_lower_place_breaks_a_tie)
{
    generator random = generator_new(4);
    for (int place = LOWEST; place < 1000; place++)
        for (int sign = -1; sign <= 1; sign += 2) {
            int exponent = place + 2 + below(&random, HIGHEST - 1002);
            twin both;
            twin_init(&both);
            add_scaled(&both, 0x1p52 + below(&random, 2), exponent);
            add_scaled(&both, 1, exponent - 1);
            add_scaled(&both, sign, place);
            judge_and_clear(&both);
        }
}
END_TEST

Suite *suite(void)
{
    Suite *accumulator = suite_create("accumulator");
    TCase *sums = tcase_create("random sums");
    tcase_add_test(sums, sums_of_all_doubles_are_exact);
    tcase_add_test(sums, sums_of_few_magnitudes_are_exact);
    tcase_add_test(sums, products_cancel_to_the_last_place);
    suite_add_tcase(accumulator, sums);
    TCase *ends = tcase_create("ends of the range");
    tcase_add_test(ends, an_empty_sum_is_zero);
    tcase_add_test(ends, a_cleared_superaccumulator_is_zero);
    tcase_add_test(ends, the_largest_and_the_smallest_sums_are_exact);
    tcase_add_test(ends, a_last_place_is_not_lost_beside_the_largest);
    suite_add_tcase(accumulator, ends);
    TCase *positions = tcase_create("all positions");
    tcase_add_test(positions, powers_of_two_in_all_positions_are_exact);
    tcase_add_test(positions, carries_run_through_many_words);
    tcase_add_test(positions, borrows_run_through_many_words);
    tcase_add_test(positions, values_are_rounded_to_nearest_and_ties_to_even);
    tcase_add_test(positions, every_lower_place_breaks_a_tie);
    suite_add_tcase(accumulator, positions);
    return accumulator;
}
