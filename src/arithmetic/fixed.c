//: Include what fixed point needs
#include "arithmetic/fixed.h"

#include "arithmetic/bits.h"
#include "arithmetic/int128.h"
#include "arithmetic/words.h"
#include "base/always_inline.h"

#include <stddef.h>

//: Compare the sizes of a column
/// The biased exponents of the largest coordinate of a column and of the least
/// that is not zero.  The latter may be too small by one.
typedef struct size_range {
    uint64_t largest, least;
} size_range;

static inline void include_size(size_range *range, double x)
{
    // Without the sign, and minus one, so that zero comes last.
    uint64_t size = tf_bits_of(x) << 1, below = size - 1;
    range->largest = size > range->largest ? size : range->largest;
    range->least = below < range->least ? below : range->least;
}

static inline size_range size_exponents(const size_range *range)
{
    return (size_range){range->largest >> 53, range->least >> 53};
}

static inline size_range column_sizes(const tf_differences *d, int n, int axis)
{
    size_range range = {0, UINT64_MAX};
    for (int i = 0; i < n; i++) {
        include_size(&range, d->to[i]->x[axis]);
        if (i == 0 || d->from[i] != d->from[i - 1])
            include_size(&range, d->from[i]->x[axis]);
    }
    return size_exponents(&range);
}

//: Choose the unit of a column
/// The exponent of the least unit of which a column's coordinates are less than
/// 2^62.
static inline int unit_exponent(const size_range *range)
{
    // All of them are below 2^(largest - 1022).
    int exponent = (int)range->largest - 1022 - TF_GRID_BITS;

    // The inverse of the unit must not overflow.
    return exponent < -1022 ? -1022 : exponent;
}

//: Test whether a column is on its grid
static bool is_multiple(double x, int exponent)
{
    double units = (double)(int64_t)(x * tf_power_of_two(-exponent));
    return units * tf_power_of_two(exponent) == x;
}

static bool column_fits(const tf_differences *d, int axis, int exponent)
{
    for (int i = 0; i < d->n; i++)
        if (!is_multiple(d->to[i]->x[axis], exponent) ||
            !is_multiple(d->from[i]->x[axis], exponent))
            return false;
    return true;
}

//: Count the units of a column
/// Puts the differences of column j into the matrix, and adds the exponent of
/// their unit; false if a coordinate lies between the points of the grid.
static inline bool count_column(const tf_differences *d, int n, int j,
                                int64_t entry[TF_AXES][TF_AXES], int *exponent)
{
    int axis = d->axis[j];
    size_range range = column_sizes(d, n, axis);
    int unit = unit_exponent(&range);
    if ((int)range.least - 1075 < unit && !column_fits(d, axis, unit))
        return false;
    double scale = tf_power_of_two(-unit);
    int64_t from = 0;
    for (int i = 0; i < n; i++) {
        if (i == 0 || d->from[i] != d->from[i - 1])
            from = (int64_t)(d->from[i]->x[axis] * scale);
        entry[i][j] = (int64_t)(d->to[i]->x[axis] * scale) - from;
    }
    *exponent += unit;
    return true;
}

//: Add a product of three words
/// low + high 2^64.
typedef struct three_words {
    uint64_t low;
    tf_int128 high;
} three_words;

static inline void add_product(three_words *sum, int64_t a, tf_int128 b)
{
    // a times the low word of b, and then times the high one.
    tf_int128 low = (tf_int128)a * (uint64_t)b + sum->low;
    sum->low = (uint64_t)low;
    sum->high +=
        (tf_int128)a * (int64_t)(b >> TF_WORD_BITS) + (low >> TF_WORD_BITS);
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
static inline bool evaluate_sized(const tf_differences *d, int n,
                                  three_words *sum, int *exponent)
{
    int64_t entry[TF_AXES][TF_AXES];
    *exponent = 0;
    for (int j = 0; j < n; j++)
        if (!count_column(d, n, j, entry, exponent))
            return false;
    *sum = multiply_out(n, entry);
    return true;
}

static inline bool evaluate(const tf_differences *d, three_words *sum,
                            int *exponent)
{
    // Where n is a constant, the compiler unrolls every loop.
    return d->n == 3   ? evaluate_sized(d, 3, sum, exponent)
           : d->n == 2 ? evaluate_sized(d, 2, sum, exponent)
                       : evaluate_sized(d, 1, sum, exponent);
}

//: Find a sign on the grid
static inline tf_sign sign_of(const three_words *sum)
{
    if (sum->high < 0)
        return TF_NEGATIVE;
    return sum->high == 0 && sum->low == 0 ? TF_ZERO : TF_POSITIVE;
}

bool tf_fixed_sign(const tf_differences *differences, tf_sign *sign)
{
    three_words sum;
    int exponent;
    if (!evaluate(differences, &sum, &exponent))
        return false;
    *sign = sign_of(&sum);
    return true;
}

//: Find a value on the grid
/// The absolute value of three words.
static inline void take_size(const three_words *sum, uint64_t word[3])
{
    // In two's complement -x is ~x + 1.
    uint64_t flip = sum->high < 0 ? UINT64_MAX : 0, carry = flip & 1;
    word[0] = sum->low;
    word[1] = (uint64_t)sum->high;
    word[2] = (uint64_t)(sum->high >> TF_WORD_BITS);
    for (int i = 0; i < 3; i++) {
        word[i] = (word[i] ^ flip) + carry;
        carry &= word[i] == 0;
    }
}

/// The sum times 2^unit, rounded.
static inline tf_value round_sum(const three_words *sum, int unit)
{
    tf_value value = {.number = 0};
    if (sum->high == 0 && sum->low == 0)
        return value;
    uint64_t word[3];
    take_size(sum, word);
    double size = tf_words_round(word, 3, &value.exponent);
    value.number = sum->high < 0 ? -size : size;
    value.exponent += unit;
    return value;
}

bool tf_fixed_value(const tf_differences *differences, tf_value *value)
{
    three_words sum;
    int unit;
    if (!evaluate(differences, &sum, &unit))
        return false;
    *value = round_sum(&sum, unit);
    return true;
}

//: Put several events on one grid
/// Counts the units of each coordinate on each axis; false if one lies between
/// the points of the grid.
static inline bool count_units(int count, const tf_event *const event[],
                               int64_t units[][TF_AXES], int exponent[TF_AXES])
{
    for (int k = 0; k < TF_AXES; k++) {
        size_range range = {0, UINT64_MAX};
        for (int i = 0; i < count; i++)
            include_size(&range, event[i]->x[k]);
        range = size_exponents(&range);
        int unit = unit_exponent(&range);
        bool fits = (int)range.least - 1075 >= unit;
        double scale = tf_power_of_two(-unit);
        for (int i = 0; i < count; i++) {
            if (!fits && !is_multiple(event[i]->x[k], unit))
                return false;
            units[i][k] = (int64_t)(event[i]->x[k] * scale);
        }
        exponent[k] = unit;
    }
    return true;
}

//: Multiply two rows
static inline void cross_rows(const int64_t a[TF_AXES],
                              const int64_t b[TF_AXES],
                              tf_int128 cross[TF_AXES])
{
    for (int k = 0; k < TF_AXES; k++)
        cross[k] = minor_of(a, b, (k + 1) % TF_AXES, (k + 2) % TF_AXES);
}

static inline three_words dot(const int64_t row[TF_AXES],
                              const tf_int128 cross[TF_AXES])
{
    three_words sum = {0, 0};
    for (int k = 0; k < TF_AXES; k++)
        add_product(&sum, row[k], cross[k]);
    return sum;
}

static inline void subtract_rows(const int64_t a[TF_AXES],
                                 const int64_t b[TF_AXES], int64_t row[TF_AXES])
{
    for (int k = 0; k < TF_AXES; k++)
        row[k] = a[k] - b[k];
}

//: Evaluate a cross product on the grid
bool tf_fixed_cross(const tf_differences *rows, tf_value component[TF_AXES])
{
    const tf_event *event[4] = {rows->to[0], rows->from[0], rows->to[1],
                                rows->from[1]};
    int64_t units[4][TF_AXES], row[2][TF_AXES];
    int unit[TF_AXES];
    if (!count_units(4, event, units, unit))
        return false;
    for (int i = 0; i < 2; i++)
        subtract_rows(units[(ptrdiff_t)2 * i], units[2 * i + 1], row[i]);
    tf_int128 cross[TF_AXES];
    cross_rows(row[0], row[1], cross);
    for (int k = 0; k < TF_AXES; k++) {
        three_words words = {(uint64_t)cross[k], cross[k] >> TF_WORD_BITS};
        component[k] = round_sum(&words, unit[(k + 1) % TF_AXES] +
                                             unit[(k + 2) % TF_AXES]);
    }
    return true;
}

//: Evaluate six determinants from two cross products
/// Adds other to sum, or subtracts it.
static inline void add_words(three_words *sum, const three_words *other,
                             bool subtract)
{
    uint64_t flip = subtract ? UINT64_MAX : 0;
    tf_int128 low = (tf_int128)sum->low + (other->low ^ flip) + (flip & 1);
    sum->low = (uint64_t)low;
    sum->high +=
        (other->high ^ (tf_int128)(int64_t)flip) + (low >> TF_WORD_BITS);
}

/// Returns the exponent of their unit in *exponent.
TF_ALWAYS_INLINE bool evaluate_rows(int start_count,
                                    const tf_event *const event[TF_SIX],
                                    three_words without[TF_SIX], int *exponent)
{
    //: Take four rows
    int64_t units[TF_SIX][TF_AXES], row[4][TF_AXES];
    int unit[TF_AXES], owner[4], count = 0;
    if (!count_units(TF_SIX, event, units, unit))
        return false;
    for (int i = 1; i < TF_SIX; i++) {
        if (i == start_count)
            continue;
        subtract_rows(units[i], units[i < start_count ? 0 : start_count],
                      row[count]);
        owner[count++] = i;
    }

    //: Leave out each row
    tf_int128 first[TF_AXES], last[TF_AXES];
    cross_rows(row[0], row[1], first);
    cross_rows(row[2], row[3], last);
    without[owner[0]] = dot(row[1], last);
    without[owner[1]] = dot(row[0], last);
    without[owner[2]] = dot(row[3], first);
    without[owner[3]] = dot(row[2], first);

    //: Leave out the first event of each time
    without[0] = without[start_count] = (three_words){0, 0};
    for (int j = 0; j < 4; j++) {
        int base = owner[j] < start_count ? 0 : start_count;
        add_words(&without[base], &without[owner[j]],
                  (owner[j] - base) % 2 == 0);
    }
    *exponent = unit[0] + unit[1] + unit[2];
    return true;
}

//: Unroll the loops over six events
static bool evaluate_six(int start_count, const tf_event *const event[TF_SIX],
                         three_words without[TF_SIX], int *exponent)
{
    return start_count == 2   ? evaluate_rows(2, event, without, exponent)
           : start_count == 3 ? evaluate_rows(3, event, without, exponent)
                              : evaluate_rows(4, event, without, exponent);
}

bool tf_fixed_six(int start_count, const tf_event *const event[TF_SIX],
                  tf_value value[TF_SIX])
{
    three_words without[TF_SIX];
    int exponent;
    if (!evaluate_six(start_count, event, without, &exponent))
        return false;
    for (int i = 0; i < TF_SIX; i++)
        value[i] = round_sum(&without[i], exponent);
    return true;
}

bool tf_fixed_six_signs(int start_count, const tf_event *const event[TF_SIX],
                        tf_sign sign[TF_SIX])
{
    three_words without[TF_SIX];
    int exponent;
    if (!evaluate_six(start_count, event, without, &exponent))
        return false;
    for (int i = 0; i < TF_SIX; i++)
        sign[i] = sign_of(&without[i]);
    return true;
}
