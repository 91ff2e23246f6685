//: Include what spelling numbers needs
#include "writers/decimal.h"

#include <math.h>
#include <stdio.h>
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

//: Scale a double to 17 digits
// A double m 2^e with e < 0 is m 10^p / 2^-e digits behind the point that is p to
// the right.  From 10^-4 on, p is 20 or less, and m 10^p has fewer than 53 + 67
// bits: it is exact, and so is the rounding.

__extension__ typedef unsigned __int128 uint128;

enum {
    DIGITS = 17
};

static const uint64_t least_digits = UINT64_C(10000000000000000);

/// Up to 10^21.
static uint128 power_of_ten(int exponent)
{
    static const uint64_t powers[] = {
        1,       10,       100,       1000,       10000,      100000,
        1000000, 10000000, 100000000, 1000000000, 10000000000};
    int half = exponent / 2;
    return (uint128)powers[half] * powers[exponent - half];
}

/// The nearest integer to number 10^point; of two, the even one.
static uint64_t scale(double number, int point)
{
    int exponent;
    uint64_t significand = (uint64_t)ldexp(frexp(number, &exponent), 53);
    uint128 wide = significand * power_of_ten(point);
    int shift = 53 - exponent;
    uint128 rest = wide & (((uint128)1 << shift) - 1);
    uint128 half = (uint128)1 << (shift - 1);
    uint64_t digits = (uint64_t)(wide >> shift);
    return digits + (rest > half || (rest == half && digits % 2));
}

/// Finds 17 digits, and how many of them are in front of the point, or below 0,
/// how many zeros are behind it.
static uint64_t find_digits(double number, int *before)
{
    *before = (int)floor(log10(number)) + 1;
    uint64_t digits = scale(number, DIGITS - *before);
    if (digits < least_digits)
        digits = scale(number, DIGITS - --*before);
    else if (digits >= 10 * least_digits)
        digits = scale(number, DIGITS - ++*before);
    return digits;
}

//: Spell a double
/// From 10^-4 to 2^52.
static char *write_ordinary(char *text, double number)
{
    char digit[DIGITS];
    int before, count = DIGITS;
    write_digits(digit, find_digits(number, &before), DIGITS);
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

char *tf_decimal_double(char text[TF_DECIMAL_ROOM], double number)
{
    double size = fabs(number);
    if (!(size >= 1e-4 && size < 0x1p52))
        return text + snprintf(text, TF_DECIMAL_ROOM, "%.17g", number);
    if (number < 0)
        *text++ = '-';
    return write_ordinary(text, size);
}
