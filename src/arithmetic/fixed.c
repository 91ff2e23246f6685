//: Include what fixed point needs
#include "arithmetic/fixed.h"

#include "arithmetic/bits.h"
#include "arithmetic/int128.h"
#include "arithmetic/words.h"


//: Compare the sizes of a column
/// Of the coordinates of a column the largest and the least that is not zero:
/// their biased exponents, which may be too small by one for the latter.
typedef struct size_range {
    uint64_t largest, least;
} size_range;

static inline void include_size(size_range *range, double x)
{
    // Without its sign; zero comes last.
    uint64_t size = tf_bits_of(x) << 1, below = size - 1;
    range->largest = size > range->largest ? size : range->largest;
    range->least = below < range->least ? below : range->least;
}

static inline size_range column_sizes(const tf_differences *d, int n, int axis)
{
    size_range range = {0, UINT64_MAX};
    for (int i = 0; i < n; i++) {
        include_size(&range, d->to[i]->x[axis]);
        if (i == 0 || d->from[i] != d->from[i - 1])
            include_size(&range, d->from[i]->x[axis]);
    }
    return (size_range){range.largest >> 53, range.least >> 53};
}

//: Choose the unit of a column
/// The exponent of the least unit of which all coordinates are less than 2^62.
static inline int unit_exponent(const size_range *range)
{
    // All are below 2^(largest - 1022).  The inverse must not overflow.
    int exponent = (int)range->largest - 1022 - TF_GRID_BITS;
    return exponent < -1022 ? -1022 : exponent;
}

//: Test whether a column is on its grid
static bool column_fits(const tf_differences *d, int axis, int exponent)
{
    double scale = tf_power_of_two(-exponent);
    double unit = tf_power_of_two(exponent);
    for (int i = 0; i < d->n; i++) {
        double to = d->to[i]->x[axis], from = d->from[i]->x[axis];
        if ((double)(int64_t)(to * scale) * unit != to ||
            (double)(int64_t)(from * scale) * unit != from)
            return false;
    }
    return true;
}

//: Put the differences on the grid
/// False if some coordinate is on no grid.
static inline bool count_differences(const tf_differences *d, int n,
                                     int64_t entry[TF_AXES][TF_AXES],
                                     int *exponent)
{
    *exponent = 0;
    for (int j = 0; j < n; j++) {
        int axis = d->axis[j];
        size_range range = column_sizes(d, n, axis);
        int own = unit_exponent(&range);
        if ((int)range.least - 1075 < own && !column_fits(d, axis, own))
            return false;
        double scale = tf_power_of_two(-own);
        *exponent += own;
        int64_t from = 0;
        for (int i = 0; i < n; i++) {
            if (i == 0 || d->from[i] != d->from[i - 1])
                from = (int64_t)(d->from[i]->x[axis] * scale);
            entry[i][j] = (int64_t)(d->to[i]->x[axis] * scale) - from;
        }
    }
    return true;
}

//: Add a product of three words
/// low + high 2^64
typedef struct three_words {
    uint64_t low;
    tf_int128 high;
} three_words;

static inline void add_product(three_words *sum, int64_t a, tf_int128 b)
{
    // Times the low word of b, and then times the high one.
    tf_int128 low = (tf_int128)a * (uint64_t)b + sum->low;
    sum->low = (uint64_t)low;
    sum->high += (tf_int128)a * (int64_t)(b >> TF_WORD_BITS) +
                 (low >> TF_WORD_BITS);
}

//: Multiply out a determinant of words
static inline tf_int128 minor_of(const int64_t row[TF_AXES],
                                 const int64_t next[TF_AXES], int k, int l)
{
    return (tf_int128)row[k] * next[l] - (tf_int128)row[l] * next[k];
}

static inline three_words multiply_out(int n, int64_t e[TF_AXES][TF_AXES])
{
    three_words sum = {0, 0};
    if (n == 1)
        add_product(&sum, e[0][0], 1);
    else if (n == 2)
        add_product(&sum, 1, minor_of(e[0], e[1], 0, 1));
    else
        for (int j = 0; j < TF_AXES; j++)
            add_product(&sum, e[0][j],
                        minor_of(e[1], e[2], (j + 1) % 3, (j + 2) % 3));
    return sum;
}

//: Evaluate a determinant on the grid
static inline bool evaluate(const tf_differences *d, int n,
                            three_words *sum, int *exponent)
{
    int64_t entry[TF_AXES][TF_AXES];
    if (!count_differences(d, n, entry, exponent))
        return false;
    *sum = multiply_out(n, entry);
    return true;
}

/// With a constant for n the compiler unrolls all loops.
static inline bool evaluate_any(const tf_differences *d, three_words *sum,
                                int *exponent)
{
    return d->n == 3   ? evaluate(d, 3, sum, exponent)
           : d->n == 2 ? evaluate(d, 2, sum, exponent)
                       : evaluate(d, 1, sum, exponent);
}

//: Find the sign of three words
bool tf_fixed_sign(const tf_differences *differences, tf_sign *sign)
{
    three_words sum;
    int exponent;
    if (!evaluate_any(differences, &sum, &exponent))
        return false;
    *sign = sum.high < 0                      ? TF_NEGATIVE
            : sum.high != 0 || sum.low != 0 ? TF_POSITIVE
                                            : TF_ZERO;
    return true;
}

//: Find the value of three words
bool tf_fixed_value(const tf_differences *differences, double *number,
                    int *exponent)
{
    three_words sum;
    int unit;
    if (!evaluate_any(differences, &sum, &unit))
        return false;

    //: Round the size of three words
    // All ones if negative.
    uint64_t sign = (uint64_t)(sum.high >> 127);
    tf_uint128 mask = sum.high >> 127;
    uint64_t low = (sum.low ^ sign) - sign;
    tf_uint128 high = ((tf_uint128)sum.high ^ mask) + (low == 0 ? mask & 1 : 0);
    uint64_t word[] = {low, (uint64_t)high, (uint64_t)(high >> TF_WORD_BITS)};
    if ((word[0] | word[1] | word[2]) == 0) {
        *number = *exponent = 0;
        return true;
    }
    double size = tf_words_round(word, 3, exponent);
    *exponent += unit;
    *number = sum.high < 0 ? -size : size;
    return true;
}
