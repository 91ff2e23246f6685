// The contender of the accumulator is exact, too.
#include "kit/expansion.h"
#include "support/dyadic.h"
#include "support/matrices.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

// Products --------------------------------------------------------------------

static void judge_product(double a, double b)
{
    mpz_t product;
    mpz_init(product);
    sum_add(product, a, b, 1);
    tf_two two = two_product(a, b);
    ck_assert_msg(sum_is(product, two.hi, two.lo),
                  "%a * %a: %a + %a (seed %llu)", a, b, two.hi, two.lo,
                  (unsigned long long)seed());
    mpz_clear(product);
}

/// A double below 2^(exponent + 53) with the last place 2^exponent, often with
/// nothing but zeros or ones in either half.
static double choose_factor(generator *random, int exponent)
{
    uint64_t half[2];
    for (int i = 0; i < 2; i++) {
        uint64_t bits = next_bits(random) >> (64 - 26);
        int kind = below(random, 4);
        half[i] = kind == 0 ? 0 : kind == 1 ? (1U << 26) - 1 : bits;
    }
    uint64_t mantissa = UINT64_C(1) << 52 | half[1] << 26 | half[0];
    return ldexp(below(random, 2) ? (double)mantissa : -(double)mantissa,
                 exponent);
}

START_TEST(products_of_two_are_exact)
{
    generator random = generator_new(3);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        // From the least last places to the largest product.
        int sum = below(&random, 4) ? below(&random, 1074 + 884) - 1074 : -1074;
        int most = sum < 0 ? 936 : 936 - sum;
        int first = sum - most + below(&random, 2 * most - sum);
        if (first < -1074 || first > 936 || sum - first < -1074)
            continue;
        judge_product(choose_factor(&random, first),
                      choose_factor(&random, sum - first));
    }
}
END_TEST

START_TEST(products_at_the_ends_of_the_range_are_exact)
{
    // The second factor is the largest, or one with the least last place.
    static const double ends[][2] = {
        {0x1.fffffffffffffp989, 1},
        {0x1.fffffffffffffp989, -0x1.fffffffffffffp-1},
        {0x1.fffffffffffffp494, 0x1.fffffffffffffp494},
        {0x1.fffffffffffffp989, 0x1.fffffffffffffp-970},
        {DBL_TRUE_MIN, 0x1.fffffffffffffp52},
        {DBL_MIN - DBL_TRUE_MIN, 0x1.fffffffffffffp52},
        {-DBL_MIN, 0x1.0000000000001p52},
        {0x1.fffffffffffffp-485, 0x1.fffffffffffffp-485},
        {0x1.0000000000001p-485, 0x1.fffffffffffffp-485},
        {0, 0x1.fffffffffffffp989},
        {0, DBL_TRUE_MIN}};
    for (int i = 0; i < (int)(sizeof ends / sizeof *ends); i++) {
        judge_product(ends[i][0], ends[i][1]);
        judge_product(ends[i][1], -ends[i][0]);
    }
}
END_TEST

// Expansions ------------------------------------------------------------------

/// Whether the terms are nonoverlapping, smallest first, and none is zero.
static bool is_expansion(const expansion *e)
{
    for (int i = 0; i < e->count; i++) {
        if (e->term[i] == 0)
            return false;
        if (i > 0 && dyadic_exponent(e->term[i]) <= ilogb(e->term[i - 1]))
            return false;
    }
    return e->count <= EXPANSION_TERMS;
}

/// Whether e = sum.
static bool equals(const expansion *e, const mpz_t sum)
{
    mpz_t rest;
    mpz_init_set(rest, sum);
    for (int i = 0; i < e->count; i++)
        sum_add(rest, -e->term[i], 1, 1);
    bool equal = mpz_sgn(rest) == 0;
    mpz_clear(rest);
    return equal;
}

static void print_terms(char *text, size_t size, const expansion *e)
{
    int length = 0;
    for (int i = 0; i < e->count; i++)
        length +=
            snprintf(text + length, size - (size_t)length, " %a", e->term[i]);
}

static void expect_of_pair(bool good, const char *what, const expansion *a,
                           const expansion *b)
{
    if (good)
        return;
    char text[2][1024] = {"", ""};
    print_terms(text[0], sizeof text[0], a);
    print_terms(text[1], sizeof text[1], b);
    ck_abort_msg("%s\nseed %llu\na%s\nb%s", what, (unsigned long long)seed(),
                 text[0], text[1]);
}

static void judge_add(const expansion *a, const expansion *b, expansion *result)
{
    expansion_add(a, b, result);
    expect_of_pair(is_expansion(result) && result->count <= a->count + b->count,
                   "a + b is no expansion", a, b);
    mpz_t sum;
    mpz_init(sum);
    for (int i = 0; i < a->count; i++)
        sum_add(sum, a->term[i], 1, 1);
    for (int i = 0; i < b->count; i++)
        sum_add(sum, b->term[i], 1, 1);
    expect_of_pair(equals(result, sum), "a + b is wrong", a, b);
    mpz_clear(sum);
}

static void judge_scale(const expansion *a, double b, expansion *result)
{
    expansion factor = {.count = 1, .term = {b}};
    expansion_scale(a, b, result);
    expect_of_pair(is_expansion(result) && result->count <= 2 * a->count,
                   "a b is no expansion", a, &factor);
    mpz_t product;
    mpz_init(product);
    for (int i = 0; i < a->count; i++)
        sum_add(product, a->term[i], b, 1);
    expect_of_pair(equals(result, product), "a b is wrong", a, &factor);
    mpz_clear(product);
}

/// An odd number of the given bits: many zeros, many ones, or any.
static uint64_t choose_mantissa(generator *random, int bits)
{
    uint64_t top = UINT64_C(1) << (bits - 1);
    switch (below(random, 3)) {
    case 0:
        return top | 1;
    case 1:
        return top | (top - 1);
    default:
        return top | (next_bits(random) & (top - 1)) | 1;
    }
}

/// Terms that do not overlap, often without a zero bit between neighbours.
static expansion choose_expansion(generator *random, int most)
{
    expansion e = {.count = 1 + below(random, most)};
    int place = below(random, 60) - 300, spread = 1 + below(random, 40);
    for (int i = 0; i < e.count; i++) {
        int bits = below(random, 2) ? 53 : 1 + below(random, 53);
        double term = (double)choose_mantissa(random, bits);
        e.term[i] = ldexp(below(random, 3) ? term : -term, place);
        place += bits + below(random, spread) / 4;
    }
    return e;
}

START_TEST(sums_of_expansions_are_exact)
{
    generator random = generator_new(4);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        expansion a = choose_expansion(&random, EXPANSION_TERMS / 2);
        expansion b = choose_expansion(&random, EXPANSION_TERMS / 2);
        expansion sum;
        judge_add(&a, &b, &sum);
        judge_add(&b, &a, &sum);
    }
}
END_TEST

START_TEST(sums_of_sums_are_exact)
{
    generator random = generator_new(5);
    long count = cases(10000);
    for (long i = 0; i < count; i++) {
        expansion a[4], sum[2], total;
        for (int k = 0; k < 4; k++)
            a[k] = choose_expansion(&random, EXPANSION_TERMS / 4);
        judge_add(&a[0], &a[1], &sum[0]);
        judge_add(&a[2], &a[3], &sum[1]);
        judge_add(&sum[0], &sum[1], &total);
    }
}
END_TEST

START_TEST(neighbours_without_a_gap_are_summed)
{
    // Scaling leaves no zero bit between the last two terms, though the terms
    // that it was given left one, or were powers of two: a sum that relies on
    // one is not to be used.
    static const expansion gaps = {
        .count = 3, .term = {0x1.ffa1391f7087bp+6, 0x1p9, -0x1p10}};
    expansion product, sum;
    judge_scale(&gaps, 0x1.ffffffff0e639p+52, &product);
    ck_assert_int_eq(dyadic_exponent(product.term[2]),
                     ilogb(product.term[1]) + 1);
    judge_add(&gaps, &product, &sum);

    // Of these a sum that carries one double makes 2^56 and 2^56.
    static const expansion a = {
        .count = 2, .term = {0x1.fffffffffffffp+55, -0x1.fffffffffffffp+108}};
    static const expansion b = {
        .count = 3,
        .term = {0x1.0000000000001p+52, 0x1.fffffffffffffp+105, 0x1.cp+108}};
    judge_add(&a, &b, &sum);
}
END_TEST

START_TEST(opposite_expansions_cancel_to_nothing)
{
    generator random = generator_new(6);
    long count = cases(10000);
    for (long i = 0; i < count; i++) {
        expansion a = choose_expansion(&random, EXPANSION_TERMS / 2);
        expansion minus_a, sum;
        judge_scale(&a, -1, &minus_a);
        judge_add(&a, &minus_a, &sum);
        expect_of_pair(sum.count == 0, "a - a is not zero", &a, &minus_a);

        // All but one of the terms.
        a.term[below(&random, a.count)] *= 2;
        if (is_expansion(&a))
            judge_add(&minus_a, &a, &sum);
    }
}
END_TEST

START_TEST(scaled_expansions_are_exact)
{
    generator random = generator_new(7);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        expansion a = choose_expansion(&random, EXPANSION_TERMS / 2);
        expansion product, sum, both;
        judge_scale(&a, choose_factor(&random, below(&random, 400) - 200),
                    &product);

        // A sum of expansions, too, as a determinant scales.
        a = choose_expansion(&random, EXPANSION_TERMS / 4);
        both = choose_expansion(&random, EXPANSION_TERMS / 4);
        judge_add(&a, &both, &sum);
        judge_scale(&sum, choose_factor(&random, 0), &product);
    }
}
END_TEST

START_TEST(zeros_add_no_terms)
{
    expansion nothing = {.count = 0}, one = {.count = 1, .term = {1}};
    expansion result;
    judge_add(&nothing, &nothing, &result);
    judge_add(&nothing, &one, &result);
    judge_add(&one, &nothing, &result);
    judge_scale(&nothing, 3, &result);
    judge_scale(&one, 0, &result);
}
END_TEST

// Determinants ----------------------------------------------------------------

/// Judge the determinant of a matrix whose differences are doubles, and tell
/// how many terms it has.
static int judge_determinant(const matrix *m)
{
    double entry[TF_AXES][TF_AXES];
    tf_differences differences = matrix_differences(m);
    tf_differences_round(&differences, entry);
    expansion result;
    expansion_determinant(m->n, entry, &result);
    expect_of_matrix(is_expansion(&result), "The determinant is no expansion",
                     m);
    mpz_t determinant;
    mpz_init(determinant);
    sum_determinant(determinant, &differences);
    expect_of_matrix(equals(&result, determinant), "The determinant is wrong",
                     m);
    expect_of_matrix(expansion_sign(&result) == sum_sign(determinant),
                     "The sign is wrong", m);
    mpz_clear(determinant);
    return result.count;
}

/// Judge the determinants of random doubles, of like or of any sizes, of which
/// `zeros` in ten are zero.
static void judge_random_determinants(long count, int zeros)
{
    generator random = generator_new(8);
    for (long i = 0; i < count; i++) {
        double entry[TF_AXES * TF_AXES] = {0};
        int n = 1 + below(&random, TF_AXES), spread = 1 + below(&random, 600);
        for (int k = 0; k < n * n; k++) {
            int exponent = below(&random, spread) - spread / 2;
            if (below(&random, 10) >= zeros)
                entry[k] = choose_factor(&random, exponent - 52);
        }
        matrix m = matrix_of(n, entry);
        judge_determinant(&m);
    }
}

START_TEST(determinants_are_exact)
{
    judge_random_determinants(cases(20000), 0);
    judge_random_determinants(cases(5000), 4);
}
END_TEST

START_TEST(a_determinant_may_have_many_terms)
{
    // The most of the 24 that a long search came upon.
    static const double entry[] = {
        0x1.46a9264c65479p+178, 0x1.0000000000199p+201, 0x1.f88e326341a37p-15,
        0x1.00000008f2c45p+24,  0x1.ad16e7175487bp+214, 0x1.88ee8d0b44c69p+8,
        0x1.0000000000001p+142, 0x1.00000007a1dcfp+195, 0x1.000001992b479p-159};
    matrix m = matrix_of(3, entry);
    ck_assert_int_eq(judge_determinant(&m), 23);
}
END_TEST

START_TEST(determinants_at_the_ends_of_their_range_are_exact)
{
    static const double ends[] = {0,        0x1p-300,
                                  0x1p300,  0x1.0000000000001p-300,
                                  -0x1p300, -0x1.fffffffffffffp-300,
                                  1,        0x1.fffffffffffffp299};
    generator random = generator_new(9);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_new(&random, 1 + below(&random, TF_AXES));
        for (int k = 0; k < matrix_size(&m); k += 2)
            *matrix_coordinate(&m, k) = ends[below(&random, 8)];
        judge_determinant(&m);
    }
}
END_TEST

START_TEST(singular_determinants_have_no_terms)
{
    generator random = generator_new(10);
    long count = cases(10000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_singular(&random, 2 + below(&random, 2));
        for (int k = 1; k < matrix_size(&m); k += 2)
            *matrix_coordinate(&m, k) = 0;
        int terms = judge_determinant(&m);
        expect_of_matrix(terms == 0, "The determinant is not zero", &m);
        double *x = matrix_coordinate(&m, 2 * below(&random, m.n * m.n));
        *x = *x == 0 ? 1 : nextafter(*x, 0);
        judge_determinant(&m);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *whole = suite_create("expansion");
    TCase *products = tcase_create("products");
    tcase_add_test(products, products_of_two_are_exact);
    tcase_add_test(products, products_at_the_ends_of_the_range_are_exact);
    suite_add_tcase(whole, products);
    TCase *expansions = tcase_create("expansions");
    tcase_add_test(expansions, sums_of_expansions_are_exact);
    tcase_add_test(expansions, sums_of_sums_are_exact);
    tcase_add_test(expansions, neighbours_without_a_gap_are_summed);
    tcase_add_test(expansions, opposite_expansions_cancel_to_nothing);
    tcase_add_test(expansions, scaled_expansions_are_exact);
    tcase_add_test(expansions, zeros_add_no_terms);
    suite_add_tcase(whole, expansions);
    TCase *determinants = tcase_create("determinants");
    tcase_add_test(determinants, determinants_are_exact);
    tcase_add_test(determinants, a_determinant_may_have_many_terms);
    tcase_add_test(determinants,
                   determinants_at_the_ends_of_their_range_are_exact);
    tcase_add_test(determinants, singular_determinants_have_no_terms);
    suite_add_tcase(whole, determinants);
    return whole;
}
