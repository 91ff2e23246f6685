//: Include what wide integers need
#include "arithmetic/wide.h"

#include "arithmetic/bits.h"
#include "arithmetic/int128.h"
#include "arithmetic/words.h"
#include "base/require.h"

#include <limits.h>
#include <string.h>

//: Find the lowest bit of a double
/// |x| = mantissa 2^exponent.
static uint64_t mantissa_of(double x, int *exponent)
{
    int biased = tf_biased_exponent(x);
    uint64_t fraction = tf_bits_of(x) & ((UINT64_C(1) << 52) - 1);
    *exponent = biased == 0 ? -1074 : biased - 1075;
    return biased == 0 ? fraction : fraction | UINT64_C(1) << 52;
}

int tf_lowest_bit(double x)
{
    int exponent;
    uint64_t mantissa = mantissa_of(x, &exponent);
    return mantissa == 0 ? INT_MAX : exponent + __builtin_ctzll(mantissa);
}

//: Make a wide integer of a double
/// Leaves out words that are zero at the top; without words it is zero.
static void trim(tf_wide *a, int count)
{
    while (count > 0 && a->word[count - 1] == 0)
        count--;
    a->count = count;
    if (count == 0)
        a->sign = TF_ZERO;
}

void tf_wide_set(double x, int unit, tf_wide *to)
{
    int exponent;
    uint64_t mantissa = mantissa_of(x, &exponent);
    to->sign = x < 0 ? TF_NEGATIVE : TF_POSITIVE;
    to->count = 0;
    if (mantissa == 0) {
        to->sign = TF_ZERO;
        return;
    }
    int empty = __builtin_ctzll(mantissa), shift = exponent + empty - unit;
    mantissa >>= empty;
    int index = shift / TF_WORD_BITS, bits = shift % TF_WORD_BITS;
    memset(to->word, 0, sizeof *to->word * (size_t)index);
    to->word[index] = mantissa << bits;
    // Two shifts, because one by 64 is not defined.
    to->word[index + 1] = mantissa >> 1 >> (TF_WORD_BITS - 1 - bits);
    trim(to, index + 2);
}

//: Compare magnitudes
static int compare_magnitudes(const tf_wide *a, const tf_wide *b)
{
    if (a->count != b->count)
        return a->count < b->count ? -1 : 1;
    for (int i = a->count - 1; i >= 0; i--)
        if (a->word[i] != b->word[i])
            return a->word[i] < b->word[i] ? -1 : 1;
    return 0;
}

//: Add and subtract magnitudes
/// `more` has as many words as `less`, or more.
static void add_magnitudes(const tf_wide *more, const tf_wide *less,
                           tf_wide *sum)
{
    int words = more->count;
    uint64_t carry = 0;
    TF_REQUIRE(words < TF_WIDE_WORDS);
    for (int i = 0; i < words; i++) {
        tf_uint128 total = (tf_uint128)more->word[i] + carry +
                           (i < less->count ? less->word[i] : 0);
        sum->word[i] = (uint64_t)total;
        carry = (uint64_t)(total >> TF_WORD_BITS);
    }
    sum->word[words] = carry;
    trim(sum, words + 1);
}

/// The magnitude of `more` is that of `less`, or more.
static void subtract_magnitudes(const tf_wide *more, const tf_wide *less,
                                tf_wide *difference)
{
    int words = more->count;
    uint64_t borrow = 0;
    for (int i = 0; i < words; i++) {
        tf_uint128 rest = (tf_uint128)more->word[i] - borrow -
                          (i < less->count ? less->word[i] : 0);
        difference->word[i] = (uint64_t)rest;
        borrow = (uint64_t)(rest >> TF_WORD_BITS) & 1;
    }
    trim(difference, words);
}

//: Add wide integers
/// Adds b, with another sign.
static void add_signed(const tf_wide *a, const tf_wide *b, tf_sign sign,
                       tf_wide *sum)
{
    bool swap = compare_magnitudes(a, b) < 0;
    const tf_wide *more = swap ? b : a, *less = swap ? a : b;
    bool agree = a->sign == sign || a->sign == TF_ZERO || sign == TF_ZERO;
    sum->sign = swap ? sign : a->sign;
    if (agree)
        add_magnitudes(more, less, sum);
    else
        subtract_magnitudes(more, less, sum);
}

void tf_wide_add(const tf_wide *a, const tf_wide *b, tf_wide *sum)
{
    add_signed(a, b, b->sign, sum);
}

void tf_wide_subtract(const tf_wide *a, const tf_wide *b, tf_wide *difference)
{
    add_signed(a, b, (tf_sign)-b->sign, difference);
}

tf_sign tf_wide_compare(const tf_wide *a, const tf_wide *b)
{
    if (a->sign != b->sign)
        return a->sign < b->sign ? TF_NEGATIVE : TF_POSITIVE;
    return (tf_sign)(a->sign * compare_magnitudes(a, b));
}

//: Multiply wide integers
void tf_wide_multiply(const tf_wide *a, const tf_wide *b, tf_wide *product)
{
    int words = a->count + b->count;
    TF_REQUIRE(words <= TF_WIDE_WORDS && product != a && product != b);
    memset(product->word, 0, sizeof *product->word * (size_t)words);
    for (int i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        for (int j = 0; j < b->count; j++) {
            tf_uint128 total = (tf_uint128)a->word[i] * b->word[j] +
                               product->word[i + j] + carry;
            product->word[i + j] = (uint64_t)total;
            carry = (uint64_t)(total >> TF_WORD_BITS);
        }
        product->word[i + b->count] = carry;
    }
    product->sign = (tf_sign)(a->sign * b->sign);
    trim(product, words);
}

//: Round a wide integer
double tf_wide_round(const tf_wide *a, int *exponent)
{
    *exponent = 0;
    if (a->count == 0)
        return 0;
    double size = tf_words_round(a->word, a->count, exponent);
    return a->sign == TF_NEGATIVE ? -size : size;
}
