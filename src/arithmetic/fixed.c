//: Include what fixed point needs
#include "arithmetic/fixed.h"

#include "arithmetic/int128.h"
#include "arithmetic/words.h"

#include <string.h>

//: Read and make powers of two
/// The bits of |x|, which are in the order of the numbers.
static uint64_t size_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits & ~(UINT64_C(1) << 63);
}

/// 2^exponent, a normal number.
static double power_of_two(int exponent)
{
    uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

//: Choose the unit of a column
/// The exponent of the least unit of which the coordinates of a column are less
/// than 2^62 each.
static inline int unit_exponent(const tf_differences *d, int n, int axis)
{
    uint64_t largest = 0;
    for (int i = 0; i < n; i++) {
        uint64_t to = size_bits(d->to[i]->x[axis]);
        uint64_t from = size_bits(d->from[i]->x[axis]);
        largest = to > largest ? to : largest;
        largest = from > largest ? from : largest;
    }
    // All are below 2^(biased - 1022).
    int exponent = (int)(largest >> 52) - 1022 - TF_GRID_BITS;

    // Neither the unit nor its inverse may be out of range.
    return exponent < -1022 ? -1022 : exponent;
}

//: Count the units of a coordinate
/// The units of x; a bit of *off becomes 1 if x is between two points.
static inline int64_t count_units(double x, double scale, double unit,
                                  uint64_t *off)
{
    int64_t units = (int64_t)(x * scale);
    *off |= size_bits((double)units * unit) ^ size_bits(x);
    return units;
}

//: Put the differences on the grid
/// False if some coordinate is on no grid.
static inline bool count_differences(const tf_differences *d, int n,
                                     int64_t entry[TF_AXES][TF_AXES],
                                     int *exponent)
{
    uint64_t off = 0;
    *exponent = 0;
    for (int j = 0; j < n; j++) {
        int axis = d->axis[j], own = unit_exponent(d, n, axis);
        double scale = power_of_two(-own), unit = power_of_two(own);
        *exponent += own;
        for (int i = 0; i < n; i++)
            entry[i][j] =
                count_units(d->to[i]->x[axis], scale, unit, &off) -
                count_units(d->from[i]->x[axis], scale, unit, &off);
    }
    return off == 0;
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
bool tf_fixed_value(const tf_differences *differences, tf_value *value)
{
    three_words sum;
    int exponent;
    if (!evaluate_any(differences, &sum, &exponent))
        return false;
    *value = (tf_value){.number = 0};
    if (sum.high == 0 && sum.low == 0)
        return true;
    bool negative = sum.high < 0;
    tf_uint128 high = (tf_uint128)sum.high;
    if (negative) {
        high = ~high + (sum.low == 0);
        sum.low = -sum.low;
    }
    uint64_t word[] = {sum.low, (uint64_t)high,
                       (uint64_t)(high >> TF_WORD_BITS)};
    *value = tf_words_round(word, 3, exponent);
    value->number = negative ? -value->number : value->number;
    return true;
}
