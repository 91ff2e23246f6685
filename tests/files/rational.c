#include "files/rational.h"

#include "support/support.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static tf_rounding round_text(const char *dividend, const char *divisor,
                              double *nearest)
{
    tf_numeral n, d;
    ck_assert(tf_numeral_read(&dividend, &n) && *dividend == '\0');
    ck_assert(tf_numeral_read(&divisor, &d) && *divisor == '\0');
    return tf_rational_round(&n, &d, nearest);
}

// The judge -------------------------------------------------------------------

/// The size of x, or of the double that would follow the largest.
static void set_size(mpq_t size, double x)
{
    if (isfinite(x)) {
        mpq_set_d(size, fabs(x));
        return;
    }
    mpq_set_ui(size, 1, 1);
    mpq_mul_2exp(size, size, 1024);
}

static bool is_even(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits % 2 == 0;
}

/// Whether `size` is on x's side of the middle between x and its neighbour, or
/// in the middle, and x is even.  `sign` is that of size - x if beyond.
static bool is_nearer(const mpq_t size, double x, double neighbour, int sign)
{
    mpq_t middle, other;
    mpq_inits(middle, other, NULL);
    set_size(middle, x);
    set_size(other, neighbour);
    mpq_add(middle, middle, other);
    mpq_div_2exp(middle, middle, 1);
    int beyond = mpq_cmp(size, middle) * sign;
    mpq_clears(middle, other, NULL);
    return beyond < 0 || (beyond == 0 && is_even(x));
}

/// Whether x, possibly infinite, is what q rounds to, by its neighbours.
static bool is_nearest(const mpq_t q, double x)
{
    mpq_t size;
    mpq_init(size);
    mpq_abs(size, q);
    double s = fabs(x);
    bool right =
        mpq_sgn(q) == 0 ? s == 0 : s == 0 || (mpq_sgn(q) > 0) == (x > 0);
    if (right && isfinite(s))
        right = is_nearer(size, s, nextafter(s, INFINITY), 1);
    if (right && s > 0)
        right = is_nearer(size, s, nextafter(s, 0), -1);
    mpq_clear(size);
    return right;
}

static bool is_exact(const mpq_t q, double x)
{
    mpq_t number;
    mpq_init(number);
    mpq_set_d(number, x);
    bool exact = mpq_equal(q, number);
    mpq_clear(number);
    return exact;
}

/// Expect n / d, also with other signs and leading zeros, as GMP has it.
static void expect_right(const mpz_t n, const mpz_t d)
{
    mpq_t q;
    mpq_init(q);
    mpq_set_num(q, n);
    mpq_set_den(q, d);
    mpq_canonicalize(q);
    char *dividend = mpz_get_str(NULL, 10, n);
    char *divisor = mpz_get_str(NULL, 10, d);

    double x = INFINITY * mpq_sgn(q);
    tf_rounding rounding = round_text(dividend, divisor, &x);
    ck_assert_int_ne(rounding, TF_ROUNDING_FAILED);
    ck_assert_msg(is_nearest(q, x), "%s / %s is not %a", dividend, divisor, x);
    ck_assert_msg((rounding == TF_ROUNDING_OVERFLOW) == !isfinite(x),
                  "%s / %s: overflow", dividend, divisor);
    if (isfinite(x))
        ck_assert_msg((rounding == TF_ROUNDING_EXACT) == is_exact(q, x),
                      "%s / %s: exactness of %a", dividend, divisor, x);
    free(dividend);
    free(divisor);
    mpq_clear(q);
}

// The cases -------------------------------------------------------------------

static void set_random(generator *random, mpz_t n, int bits)
{
    mpz_set_ui(n, 1);
    for (int i = 0; i < bits; i += 32) {
        mpz_mul_2exp(n, n, 32);
        mpz_add_ui(n, n, next_bits(random) >> 32);
    }
    mpz_fdiv_r_2exp(n, n, (mp_bitcnt_t)bits);
    mpz_setbit(n, (mp_bitcnt_t)bits);
    if (below(random, 2))
        mpz_neg(n, n);
}

static void try_random(long count, int most_bits)
{
    generator random = generator_new((uint64_t)most_bits);
    mpz_t n, d;
    mpz_inits(n, d, NULL);
    for (long i = 0; i < count; i++) {
        set_random(&random, n, below(&random, most_bits));
        set_random(&random, d, below(&random, most_bits));
        expect_right(n, d);
    }
    mpz_clears(n, d, NULL);
}

START_TEST(random_short_rationals_are_rounded_right)
{
    try_random(cases(50000), 64);
}
END_TEST

START_TEST(random_long_rationals_are_rounded_right)
{
    try_random(cases(50000), 1000);
}
END_TEST

START_TEST(random_rationals_beyond_the_doubles_overflow_or_vanish)
{
    try_random(cases(20000), 2600);
}
END_TEST

/// The middle of x and the next double, times `factor` above and below, plus
/// `more` above: halfway, or just off it.
static void try_halfway(double x, const mpz_t factor, int more)
{
    mpq_t middle, next;
    mpq_inits(middle, next, NULL);
    set_size(middle, x);
    set_size(next, nextafter(x, INFINITY));
    mpq_add(middle, middle, next);
    mpq_div_2exp(middle, middle, 1);
    mpz_mul(mpq_numref(middle), mpq_numref(middle), factor);
    mpz_mul(mpq_denref(middle), mpq_denref(middle), factor);
    if (more > 0)
        mpz_add_ui(mpq_numref(middle), mpq_numref(middle), 1);
    if (more < 0)
        mpz_sub_ui(mpq_numref(middle), mpq_numref(middle), 1);
    expect_right(mpq_numref(middle), mpq_denref(middle));
    mpq_clears(middle, next, NULL);
}

static double any_size(generator *random)
{
    double x;
    uint64_t bits = next_bits(random) >> 1;
    if (below(random, 4) == 0)
        bits >>= 12 + below(random, 40); // subnormal
    memcpy(&x, &bits, sizeof x);
    return isfinite(x) ? x : any_size(random);
}

START_TEST(halfway_between_two_doubles_goes_to_even)
{
    generator random = generator_new(3);
    mpz_t factor;
    mpz_init(factor);
    for (long i = 0; i < cases(30000); i++) {
        set_random(&random, factor, below(&random, 300));
        try_halfway(any_size(&random), factor, below(&random, 3) - 1);
    }
    mpz_clear(factor);
}
END_TEST

START_TEST(halfway_at_the_ends_of_the_range_is_rounded_right)
{
    static const double ends[] = {0,
                                  0x1p-1074,
                                  0x1p-1073,
                                  0x0.fffffffffffffp-1022,
                                  0x1p-1022,
                                  0x1.fffffffffffffp-1022,
                                  0x1.fffffffffffffp+1023,
                                  0x1.ffffffffffffep+1023};
    mpz_t factor;
    mpz_init(factor);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        for (int more = -1; more <= 1; more++) {
            mpz_set_si(factor, 1);
            try_halfway(ends[i], factor, more);
            mpz_ui_pow_ui(factor, 7, 100);
            try_halfway(ends[i], factor, more);
        }
    mpz_clear(factor);
}
END_TEST

/// 10^n / 10^d, near the ends of the range, where a glance at the lengths
/// decides.
START_TEST(powers_of_ten_are_rounded_right)
{
    mpz_t n, d;
    mpz_inits(n, d, NULL);
    for (unsigned long ten = 0; ten <= 20; ten += 20)
        for (unsigned long more = 300; more < 330; more++)
            for (unsigned long digit = 1; digit < 10; digit += 4) {
                mpz_ui_pow_ui(n, 10, ten + more);
                mpz_mul_ui(n, n, digit);
                mpz_ui_pow_ui(d, 10, ten);
                mpz_mul_ui(d, d, 10 - digit);
                expect_right(n, d);
                expect_right(d, n);
            }
    mpz_clears(n, d, NULL);
}
END_TEST

START_TEST(three_hundred_digits_are_rounded_right)
{
    mpz_t n, d;
    mpz_inits(n, d, NULL);
    mpz_ui_pow_ui(d, 10, 299);
    mpz_mul_ui(n, d, 3);
    mpz_add_ui(n, n, 1);
    expect_right(n, d);
    mpz_set(n, d);
    mpz_mul_ui(d, d, 3);
    expect_right(n, d);
    mpz_neg(d, d);
    expect_right(n, d);
    mpz_clears(n, d, NULL);
}
END_TEST

START_TEST(fifty_thousand_digits_are_rounded_right)
{
    mpz_t n, d;
    mpz_inits(n, d, NULL);
    mpz_ui_pow_ui(n, 3, 104800);
    mpz_ui_pow_ui(d, 2, 166100);
    expect_right(n, d);
    expect_right(d, n);
    mpz_set_ui(d, 3);
    expect_right(n, d);
    expect_right(d, n);
    mpz_clears(n, d, NULL);
}
END_TEST

START_TEST(signs_and_zeros_are_kept)
{
    double x;
    ck_assert_int_eq(round_text("-3", "-4", &x), TF_ROUNDING_EXACT);
    ck_assert(x == 0.75);
    ck_assert_int_eq(round_text("+3", "-4", &x), TF_ROUNDING_EXACT);
    ck_assert(x == -0.75);
    ck_assert_int_eq(round_text("-0003", "000004", &x), TF_ROUNDING_EXACT);
    ck_assert(x == -0.75);
    ck_assert_int_eq(round_text("0", "7", &x), TF_ROUNDING_EXACT);
    ck_assert(x == 0);
    ck_assert_int_eq(round_text("-00", "100000000000000000000000000000", &x),
                     TF_ROUNDING_EXACT);
    ck_assert(x == 0);
}
END_TEST

START_TEST(leading_zeros_are_no_digits)
{
    char text[1001];
    memset(text, '0', 1000);
    strcpy(text + 999, "5");
    double x;
    ck_assert_int_eq(round_text(text, "8", &x), TF_ROUNDING_EXACT);
    ck_assert(x == 0.625);
}
END_TEST

START_TEST(what_is_no_integer_is_left_alone)
{
    static const char *const texts[] = {"",   "-",   "+",   ".5", "a1",
                                        " 1", "--1", "+-1", ",",  "nan"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const char *at = texts[i];
        tf_numeral numeral;
        ck_assert_msg(!tf_numeral_read(&at, &numeral) && at == texts[i], "'%s'",
                      texts[i]);
    }
}
END_TEST

START_TEST(an_integer_ends_where_it_ends)
{
    const char *text = "-0012.5";
    tf_numeral numeral;
    ck_assert(tf_numeral_read(&text, &numeral));
    ck_assert_str_eq(text, ".5");
    ck_assert(numeral.negative);
    ck_assert_uint_eq(numeral.count, 2);
    ck_assert_int_eq(strncmp(numeral.digit, "12", 2), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/rational");
    TCase *numerals = tcase_create("numerals");
    tcase_add_test(numerals, what_is_no_integer_is_left_alone);
    tcase_add_test(numerals, an_integer_ends_where_it_ends);
    tcase_add_test(numerals, signs_and_zeros_are_kept);
    tcase_add_test(numerals, leading_zeros_are_no_digits);
    suite_add_tcase(suite, numerals);

    TCase *rounding = tcase_create("rounding");
    tcase_add_test(rounding, random_short_rationals_are_rounded_right);
    tcase_add_test(rounding, random_long_rationals_are_rounded_right);
    tcase_add_test(rounding,
                   random_rationals_beyond_the_doubles_overflow_or_vanish);
    tcase_add_test(rounding, halfway_between_two_doubles_goes_to_even);
    tcase_add_test(rounding, halfway_at_the_ends_of_the_range_is_rounded_right);
    tcase_add_test(rounding, powers_of_ten_are_rounded_right);
    tcase_add_test(rounding, three_hundred_digits_are_rounded_right);
    tcase_add_test(rounding, fifty_thousand_digits_are_rounded_right);
    suite_add_tcase(suite, rounding);
    return suite;
}
