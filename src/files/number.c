//: Include what numbers need
#include "files/number.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

//: Tabulate the hexadecimal digits
// One more than the digit's value, so that all other characters are zero.
static const unsigned char hexadecimal[256] = {
    ['0'] = 1,  ['1'] = 2,  ['2'] = 3,  ['3'] = 4,  ['4'] = 5,  ['5'] = 6,
    ['6'] = 7,  ['7'] = 8,  ['8'] = 9,  ['9'] = 10, ['a'] = 11, ['b'] = 12,
    ['c'] = 13, ['d'] = 14, ['e'] = 15, ['f'] = 16, ['A'] = 11, ['B'] = 12,
    ['C'] = 13, ['D'] = 14, ['E'] = 15, ['F'] = 16,
};

//: Read the digits before the exponent
/// Up to 16 digits, with or without a point, as significand 2^exponent.  False
/// if there are none, or more than fit.
static bool read_significand(const char **text, uint64_t *significand,
                             int64_t *exponent)
{
    const char *at = *text, *point = NULL;
    int64_t digits = 0;
    for (; hexadecimal[(unsigned char)*at] || (*at == '.' && !point); at++) {
        if (*at == '.') {
            point = at;
            continue;
        }
        if (*significand >> 60)
            return false;
        *significand = 16 * *significand + hexadecimal[(unsigned char)*at] - 1;
        *exponent -= point ? 4 : 0;
        digits++;
    }
    *text = at;
    return digits > 0;
}

//: Read the exponent
/// Add what follows the letter p, if anything does.  False if it is no integer
/// of 1 to 4 digits.
static bool read_exponent(const char **text, int64_t *exponent)
{
    const char *at = *text;
    if (*at != 'p' && *at != 'P')
        return true;
    at++;
    bool negative = *at == '-';
    at += *at == '-' || *at == '+';
    const char *first = at;
    int size = 0;
    for (; *at >= '0' && *at <= '9' && at - first < 5; at++)
        size = 10 * size + (*at - '0');
    *exponent += negative ? -size : size;
    *text = at;
    return at - first >= 1 && at - first <= 4;
}

//: Make a power of two
static double power_of_two(int64_t exponent)
{
    uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

//: Read a hexadecimal float of at most 16 digits
// The significand is rounded when it becomes a double.  With its exponent in
// this range no more is: the product is exact, never subnormal, or infinite.
static bool read_hexadecimal(const char **text, double *number)
{
    const char *at = *text;
    bool negative = *at == '-';
    at += *at == '-' || *at == '+';
    if (at[0] != '0' || (at[1] != 'x' && at[1] != 'X'))
        return false;
    at += 2;

    uint64_t significand = 0;
    int64_t exponent = 0;
    if (!read_significand(&at, &significand, &exponent) ||
        !read_exponent(&at, &exponent) || exponent < -1022 || exponent > 1023)
        return false;
    double size = (double)significand * power_of_two(exponent);
    *number = negative ? -size : size;
    *text = at;
    return true;
}

//: Read any number
// strtod alone would also take blanks, "nan" and "inf".
static bool starts_number(const char *at)
{
    at += *at == '-' || *at == '+';
    at += *at == '.';
    return *at >= '0' && *at <= '9';
}

bool tf_number_read(const char **text, double *number)
{
    if (read_hexadecimal(text, number))
        return true;
    if (!starts_number(*text))
        return false;
    char *end;
    *number = strtod(*text, &end);
    *text = end;
    return true;
}

//: Read an integer that an int holds
bool tf_integer_read(const char **text, int64_t *integer)
{
    bool negative = **text == '-';
    const char *first = *text + (negative || **text == '+'), *at = first;
    int64_t size = 0;
    for (; *at >= '0' && *at <= '9'; at++)
        if (size <= INT_MAX)
            size = 10 * size + (*at - '0');
    if (at == first)
        return false;
    *integer = negative ? -size : size;
    *text = at;
    return true;
}
