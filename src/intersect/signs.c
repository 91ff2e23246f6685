//: Orient a barycentric coordinate
#include "intersect/signs.h"

#include "arithmetic/functions.h"

// Sorting a determinant's rows by time, subtracting the first of each time and
// expanding along the columns t and 1 leaves (-1)^(number at t = 0) times the
// determinant of the differences, so apart from the (-1)^i of Cramer's rule,
// only the events at the end change sign.
int tf_pair_orientation(const tf_pair *pair, int i)
{
    int alternating = i % 2 == 0 ? 1 : -1;
    int time = i < pair->start_count ? 1 : -1;
    return alternating * time * pair->operand[i];
}

//: Take the signs that are proved at once
static void estimate_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                           tf_sign sign[TF_PAIR_EVENTS])
{
    if (pair->count == TF_SIX && arithmetic->six_estimates)
        arithmetic->six_estimates(pair->start_count, pair->event, sign);
    else
        for (int i = 0; i < pair->count; i++)
            sign[i] = TF_UNKNOWN;
}

/// Turns them into signs of barycentric coordinates; as tf_pair_sure_signs.
static inline bool turn_signs(const tf_pair *pair, int count, tf_signs *signs)
{
    bool positive = false, negative = false, unknown = false;
    for (int i = 0; i < count; i++) {
        int turned = signs->sign[i] * tf_pair_orientation(pair, i);
        positive |= turned == TF_POSITIVE;
        negative |= turned == TF_NEGATIVE;
        unknown |= signs->sign[i] == TF_UNKNOWN;
        signs->sign[i] =
            signs->sign[i] == TF_UNKNOWN ? TF_UNKNOWN : (tf_sign)turned;
    }
    signs->positive = positive;
    signs->negative = negative;
    signs->zero = signs->unknown = false;
    return !unknown || (positive && negative);
}

bool tf_pair_sure_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                        tf_signs *signs)
{
    estimate_signs(arithmetic, pair, signs->sign);
    // With a constant the compiler unrolls the loop.
    return pair->count == TF_SIX ? turn_signs(pair, TF_SIX, signs)
                                 : turn_signs(pair, pair->count, signs);
}

//: Find one sign
static tf_sign sign_without(const tf_arithmetic *arithmetic,
                            const tf_pair *pair, int i)
{
    tf_differences differences;
    tf_pair_differences(pair, i, &differences);
    return arithmetic->sign(&differences);
}

//: Stop at the first conflict
void tf_pair_other_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                         tf_signs *signs)
{
    tf_sign all[TF_SIX];
    bool at_once = pair->count == TF_SIX && arithmetic->six_signs &&
                   arithmetic->six_signs(pair->start_count, pair->event, all);
    bool positive = signs->positive, negative = signs->negative;
    bool zero = false, unknown = false;
    for (int i = 0; i < pair->count && !(positive && negative); i++) {
        if (signs->sign[i] != TF_UNKNOWN)
            continue;
        tf_sign sign = at_once ? all[i] : sign_without(arithmetic, pair, i);
        if (sign == TF_POSITIVE || sign == TF_NEGATIVE)
            sign = (tf_sign)(sign * tf_pair_orientation(pair, i));
        signs->sign[i] = sign;
        positive |= sign == TF_POSITIVE;
        negative |= sign == TF_NEGATIVE;
        zero |= sign == TF_ZERO;
        unknown |= sign == TF_UNKNOWN;
    }
    signs->positive = positive;
    signs->negative = negative;
    signs->zero = zero;
    signs->unknown = unknown;
}
