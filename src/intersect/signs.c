//: Orient a barycentric coordinate
#include "intersect/signs.h"

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

//: Stop at the first conflict
void tf_pair_signs(const tf_arithmetic *arithmetic, const tf_pair *pair,
                   tf_signs *signs)
{
    bool positive = false, negative = false, zero = false, unknown = false;
    for (int i = 0; i < pair->count && !(positive && negative); i++) {
        tf_differences differences;
        tf_pair_differences(pair, i, &differences);
        tf_sign sign = arithmetic->sign(&differences);
        if (sign == TF_POSITIVE || sign == TF_NEGATIVE)
            sign = (tf_sign)(sign * tf_pair_orientation(pair, i));
        signs->of[i] = sign;
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
