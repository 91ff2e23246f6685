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
/// Units to a coordinate of 1, and the other way round.
typedef struct column_grid {
    double scale, unit;
} column_grid;

/// The exponent of the least unit of which the coordinates of a column are less
/// than 2^62 each.
static int unit_exponent(const tf_differences *d, int axis)
{
    uint64_t largest = 0;
    for (int i = 0; i < d->n; i++) {
        uint64_t to = size_bits(d->to[i]->x[axis]);
        uint64_t from = size_bits(d->from[i]->x[axis]);
        largest = to > largest ? to : largest;
        largest = from > largest ? from : largest;
    }
    // All are below 2^(biased - 1022).
    int exponent = (int)(largest >> 52) - 1022 - TF_FIXED_BITS;

    // The scale must not overflow.
    return exponent < -1022 ? -1022 : exponent;
}

//: Put a coordinate on the grid
/// The units of a coordinate; *off becomes true if it is between two points.
static int64_t count_units(double x, column_grid grid, bool *off)
{
    int64_t units = (int64_t)(x * grid.scale);
    *off |= (double)units * grid.unit != x;
    return units;
}

//: Put all differences on the grid
/// False if some coordinate is on no grid.
static bool count_all(const tf_differences *d, int64_t entry[TF_AXES][TF_AXES],
                      int *exponent)
{
    bool off = false;
    *exponent = 0;
    for (int j = 0; j < d->n; j++) {
        int axis = d->axis[j], own = unit_exponent(d, axis);
        column_grid grid = {power_of_two(-own), power_of_two(own)};
        *exponent += own;
        for (int i = 0; i < d->n; i++)
            entry[i][j] = count_units(d->to[i]->x[axis], grid, &off) -
                          count_units(d->from[i]->x[axis], grid, &off);
    }
    return !off;
}

//: Add a product of three words
/// low + high 2^64
typedef struct three_words {
    uint64_t low;
    tf_int128 high;
} three_words;

static void add_product(three_words *sum, int64_t a, tf_int128 b)
{
    // Times the low word of b, and then times the high one.
    tf_int128 low = (tf_int128)a * (uint64_t)b + sum->low;
    sum->low = (uint64_t)low;
    sum->high += (tf_int128)a * (int64_t)(b >> TF_WORD_BITS) +
                 (low >> TF_WORD_BITS);
}

//: Multiply out a determinant of words
static tf_int128 minor(int64_t a, int64_t b, int64_t c, int64_t d)
{
    return (tf_int128)a * d - (tf_int128)b * c;
}

static three_words multiply_out(int n, int64_t e[TF_AXES][TF_AXES])
{
    three_words sum = {0, 0};
    if (n == 1)
        add_product(&sum, 1, e[0][0]);
    else if (n == 2)
        add_product(&sum, 1, minor(e[0][0], e[0][1], e[1][0], e[1][1]));
    else
        for (int j = 0; j < TF_AXES; j++) {
            int k = (j + 1) % TF_AXES, l = (j + 2) % TF_AXES;
            add_product(&sum, e[0][j],
                        minor(e[1][k], e[1][l], e[2][k], e[2][l]));
        }
    return sum;
}

//: Evaluate a determinant on the grid
bool tf_fixed_determinant(const tf_differences *differences, tf_fixed *fixed)
{
    int64_t entry[TF_AXES][TF_AXES];
    if (!count_all(differences, entry, &fixed->exponent))
        return false;
    three_words sum = multiply_out(differences->n, entry);
    fixed->word[0] = sum.low;
    fixed->word[1] = (uint64_t)sum.high;
    fixed->word[2] = (uint64_t)(sum.high >> TF_WORD_BITS);
    return true;
}

//: Find the sign of three words
tf_sign tf_fixed_sign(const tf_fixed *fixed)
{
    const uint64_t *word = fixed->word;
    if (word[2] >> 63)
        return TF_NEGATIVE;
    return (word[0] | word[1] | word[2]) != 0 ? TF_POSITIVE : TF_ZERO;
}

//: Find the value of three words
/// Changes the sign of a number in two's complement.
static void negate(uint64_t word[TF_FIXED_WORDS])
{
    uint64_t carry = 1;
    for (int i = 0; i < TF_FIXED_WORDS; i++) {
        word[i] = ~word[i] + carry;
        carry &= word[i] == 0;
    }
}

tf_value tf_fixed_value(const tf_fixed *fixed)
{
    tf_sign sign = tf_fixed_sign(fixed);
    if (sign == TF_ZERO)
        return (tf_value){.number = 0};
    tf_fixed size = *fixed;
    if (sign == TF_NEGATIVE)
        negate(size.word);
    tf_value value = tf_words_round(size.word, TF_FIXED_WORDS, size.exponent);
    value.number *= sign;
    return value;
}
