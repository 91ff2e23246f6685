//: Include what the superaccumulator needs
#include "arithmetic/superaccumulator.h"

#include "arithmetic/bits.h"
#include "arithmetic/int128.h"
#include "arithmetic/words.h"

#include <math.h>

enum {
    UNIT_EXPONENT = -3222
};

//: Clear the superaccumulator
void tf_superaccumulator_clear(tf_superaccumulator *accumulator)
{
    accumulator->first = accumulator->end = 0;
}

//: Use more words
/// Sets the words first..end-1 of both sums to zero, unless in use.
static void use_words(tf_superaccumulator *accumulator, int first, int end)
{
    tf_superaccumulator *a = accumulator;
    if (a->first == a->end)
        a->first = a->end = first;
    for (; a->end < end; a->end++)
        a->sum[0][a->end] = a->sum[1][a->end] = 0;
    while (a->first > first) {
        a->first--;
        a->sum[0][a->first] = a->sum[1][a->first] = 0;
    }
}

//: Decompose a double
/// |a| = mantissa 2^exponent.
typedef struct parts {
    uint64_t mantissa;
    int exponent;
} parts;

static parts decompose(double a)
{
    int biased = tf_biased_exponent(a);
    uint64_t fraction = tf_bits_of(a) & ((UINT64_C(1) << 52) - 1);

    // A subnormal number has the exponent of the smallest normal one, without
    // its leading bit.
    if (biased == 0)
        return (parts){.mantissa = fraction, .exponent = -1074};
    return (parts){.mantissa = fraction | UINT64_C(1) << 52,
                   .exponent = biased - 1075};
}

//: Add words at a bit position
/// Adds three words, shifted left by `position` bits, to the sum of one sign.
static void add_words(tf_superaccumulator *accumulator, bool positive,
                      const uint64_t word[3], int position)
{
    int index = position / TF_WORD_BITS, shift = position % TF_WORD_BITS;
    uint64_t *sum = accumulator->sum[positive], below = 0, carry = 0;
    use_words(accumulator, index, index + 3);
    for (int i = 0; i < 3; i++) {
        uint64_t shifted = word[i] << shift | below;
        // Two shifts, because one by 64 is not defined.
        below = word[i] >> 1 >> (TF_WORD_BITS - 1 - shift);
        tf_uint128 total = (tf_uint128)sum[index] + shifted + carry;
        sum[index++] = (uint64_t)total;
        carry = (uint64_t)(total >> TF_WORD_BITS);
    }
    for (carry += below; carry != 0; index++) {
        use_words(accumulator, index, index + 1);
        sum[index] += carry;
        carry = sum[index] < carry;
    }
}

//: Add a product
void tf_superaccumulator_add(tf_superaccumulator *accumulator, double a,
                             double b, double c)
{
    parts x = decompose(a), y = decompose(b), z = decompose(c);
    bool positive = !signbit(a) ^ !signbit(b) ^ !signbit(c);

    //: Multiply the mantissas
    tf_uint128 two = (tf_uint128)x.mantissa * y.mantissa;
    tf_uint128 low = (tf_uint128)(uint64_t)two * z.mantissa;
    tf_uint128 high =
        (two >> TF_WORD_BITS) * z.mantissa + (low >> TF_WORD_BITS);
    uint64_t word[3] = {(uint64_t)low, (uint64_t)high,
                        (uint64_t)(high >> TF_WORD_BITS)};

    //: Add the product to the sum of its sign
    int exponent = x.exponent + y.exponent + z.exponent;
    add_words(accumulator, positive, word, exponent - UNIT_EXPONENT);
}

//: Compare the two sums
/// The highest word in which the two sums differ; first - 1 if they are equal.
static int highest_difference(const tf_superaccumulator *accumulator)
{
    int i = accumulator->end - 1;
    while (i >= accumulator->first &&
           accumulator->sum[0][i] == accumulator->sum[1][i])
        i--;
    return i;
}

tf_sign tf_superaccumulator_sign(const tf_superaccumulator *accumulator)
{
    int i = highest_difference(accumulator);
    if (i < accumulator->first)
        return TF_ZERO;
    return accumulator->sum[1][i] > accumulator->sum[0][i] ? TF_POSITIVE
                                                           : TF_NEGATIVE;
}

//: Subtract the smaller sum
/// Subtracts `less` from `more`, both of `count` words and less <= more.
static void subtract(const uint64_t *more, const uint64_t *less, int count,
                     uint64_t difference[])
{
    uint64_t borrow = 0;
    for (int i = 0; i < count; i++) {
        tf_uint128 d = (tf_uint128)more[i] - less[i] - borrow;
        difference[i] = (uint64_t)d;
        borrow = (uint64_t)(d >> TF_WORD_BITS) & 1;
    }
}

//: Find the value of the sum
tf_value tf_superaccumulator_value(const tf_superaccumulator *accumulator)
{
    int top = highest_difference(accumulator), first = accumulator->first;
    if (top < first)
        return (tf_value){.number = 0};

    uint64_t difference[TF_SUPERACCUMULATOR_WORDS];
    const uint64_t(*sum)[TF_SUPERACCUMULATOR_WORDS] = accumulator->sum;
    bool positive = sum[1][top] > sum[0][top];
    int count = top + 1 - first;
    subtract(&sum[positive][first], &sum[!positive][first], count, difference);
    int exponent;
    double size = tf_words_round(difference, count, &exponent);
    return (tf_value){.number = positive ? size : -size,
                      .exponent =
                          exponent + first * TF_WORD_BITS + UNIT_EXPONENT};
}
