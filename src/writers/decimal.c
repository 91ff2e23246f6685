//: Include what spelling numbers needs
#include "writers/decimal.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Spell an integer
/// The digits of a number, with zeros in front if there are fewer; returns their
/// end.
static char *write_digits(char *text, uint64_t number, int digits)
{
    for (int i = digits - 1; i >= 0; i--) {
        text[i] = (char)('0' + number % 10);
        number /= 10;
    }
    return text + digits;
}

char *tf_decimal_integer(char text[TF_DECIMAL_ROOM], int64_t number)
{
    uint64_t size = number < 0 ? -(uint64_t)number : (uint64_t)number;
    int digits = 1;
    for (uint64_t rest = size; rest >= 10; rest /= 10)
        digits++;
    if (number < 0)
        *text++ = '-';
    return write_digits(text, size, digits);
}

//: Scale a double to an integer
// A double m 2^e with e < 0 is m 10^p / 2^-e digits behind the point that is p to
// the right.  From 10^-4 on, p is 20 or less, and m 10^p has fewer than 53 + 67
// bits: it is exact, and so is the rounding.

__extension__ typedef unsigned __int128 uint128;

enum {
    SURE =
        15, // digits of which all double numbers are told apart that have them
    MOST = 17 // that determine a double
};

/// Up to 10^20.
static uint128 power_of_ten(int exponent)
{
    static const uint64_t powers[] = {
        1,       10,       100,       1000,       10000,      100000,
        1000000, 10000000, 100000000, 1000000000, 10000000000};
    int half = exponent / 2;
    return (uint128)powers[half] * powers[exponent - half];
}

/// A double as an integer times a power of 2.
typedef struct parts {
    uint64_t significand; ///< of 53 bits
    int shift;            ///< the power is 2^-shift
} parts;

static parts take_apart(double number)
{
    int exponent;
    uint64_t significand = (uint64_t)ldexp(frexp(number, &exponent), 53);
    return (parts){significand, 53 - exponent};
}

/// The nearest integer to number 10^point; of two, the even one.
static uint64_t scale(parts number, int point)
{
    uint128 wide = number.significand * power_of_ten(point);
    uint128 rest = wide & (((uint128)1 << number.shift) - 1);
    uint128 half = (uint128)1 << (number.shift - 1);
    uint64_t digits = (uint64_t)(wide >> number.shift);
    return digits + (rest > half || (rest == half && digits % 2));
}

//: Find the fewest digits of a double
/// Whether the double that is nearest to digits 10^-point is that number: less
/// than half a unit of its last place away.  Below a power of 2 it would have to
/// be a quarter, but those down to 10^-4 have 13 digits or fewer.
static bool determine(uint64_t digits, parts number, int point)
{
    uint128 ten = power_of_ten(point), own = number.significand * ten;
    uint128 other = (uint128)digits << number.shift;
    return 2 * (other < own ? own - other : other - own) < ten;
}

/// How many digits a double has in front of the point, or below 0, how many zeros
/// are behind it.
static int find_point(double number, parts taken)
{
    int before = (int)floor(log10(number)) + 1;
    uint128 wide = taken.significand * power_of_ten(MOST - before);
    uint64_t digits = (uint64_t)(wide >> taken.shift);
    uint64_t least = (uint64_t)power_of_ten(MOST - 1);
    return before + (digits >= 10 * least) - (digits < least);
}

/// Finds 15 digits or, if they do not determine the number, 16 or 17.
static uint64_t find_fewest(double number, int *count, int *before)
{
    parts taken = take_apart(number);
    uint64_t digits = 0;
    *before = find_point(number, taken);
    *count = SURE - 1;
    do
        digits = scale(taken, ++*count - *before);
    while (*count < MOST && !determine(digits, taken, *count - *before));
    if (digits < (uint64_t)power_of_ten(*count))
        return digits;
    ++*before;
    return digits / 10;
}

//: Spell a double
/// From 10^-4 to 2^49, in front of whose point are at most 15 digits.
static char *write_ordinary(char *text, double number)
{
    char digit[MOST];
    int before, count;
    uint64_t digits = find_fewest(number, &count, &before);
    write_digits(digit, digits, count);
    while (count > before && count > 1 && digit[count - 1] == '0')
        count--;
    if (before <= 0) {
        *text++ = '0';
        *text++ = '.';
        memset(text, '0', (size_t)-before);
        memcpy(text - before, digit, (size_t)count);
        return text - before + count;
    }
    memcpy(text, digit, (size_t)before);
    text += before;
    if (count > before) {
        *text++ = '.';
        memcpy(text, digit + before, (size_t)(count - before));
        text += count - before;
    }
    return text;
}

/// Any other number.
static char *write_other(char text[TF_DECIMAL_ROOM], double number)
{
    int length = 0;
    for (int digits = SURE; digits <= MOST; digits++) {
        length = snprintf(text, TF_DECIMAL_ROOM, "%.*g", digits, number);
        if (strtod(text, NULL) == number)
            break;
    }
    return text + length;
}

char *tf_decimal_double(char text[TF_DECIMAL_ROOM], double number)
{
    double size = fabs(number);
    if (!(size >= 1e-4 && size < 0x1p49))
        return write_other(text, number);
    if (number < 0)
        *text++ = '-';
    return write_ordinary(text, size);
}
