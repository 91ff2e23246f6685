//: Include what rationals need
#include "files/rational.h"

#include "base/require.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

//: Read a numeral
bool tf_numeral_read(const char **text, tf_numeral *numeral)
{
    const char *at = *text;
    numeral->negative = *at == '-';
    at += *at == '-' || *at == '+';

    const char *first = at;
    while (*at == '0')
        at++;
    numeral->digit = at;
    while (*at >= '0' && *at <= '9')
        at++;
    numeral->count = (size_t)(at - numeral->digit);
    if (at == first)
        return false;
    *text = at;
    return true;
}

//: Turn a short numeral into a double
/// False if it may be no double: 18 digits fit 64 bits, but not always 53.
static bool short_integer(const tf_numeral *numeral, double *number)
{
    if (numeral->count > 18)
        return false;
    uint64_t integer = 0;
    for (size_t i = 0; i < numeral->count; i++)
        integer = 10 * integer + (uint64_t)(numeral->digit[i] - '0');
    *number = (double)integer;
    return (uint64_t)*number == integer;
}

//: Divide two short numerals
// The quotient is rounded once, by the processor, and is far from subnormal;
// then the remainder is a double, and the fused operation finds it exactly.
static bool divide_short(const tf_numeral *dividend, const tf_numeral *divisor,
                         double *nearest, bool *exact)
{
    double n, d;
    if (!short_integer(dividend, &n) || !short_integer(divisor, &d))
        return false;
    *nearest = n / d;
    *exact = fma(*nearest, d, -n) == 0;
    return true;
}

//: Represent a natural number of any length
/// Its digits to base 2^64, the lowest first; the highest is not zero.
typedef struct natural {
    size_t count;
    uint64_t *limb;
} natural;

__extension__ typedef unsigned __int128 two_limbs;

static void drop_leading_zeros(natural *n)
{
    while (n->count > 0 && n->limb[n->count - 1] == 0)
        n->count--;
}

static long bit_length(const natural *n)
{
    return 64 * (long)n->count - __builtin_clzll(n->limb[n->count - 1]);
}

//: Convert decimal digits, 19 at a time
static void multiply_add(natural *n, uint64_t factor, uint64_t summand)
{
    two_limbs carry = summand;
    for (size_t i = 0; i < n->count; i++) {
        carry += (two_limbs)n->limb[i] * factor;
        n->limb[i] = (uint64_t)carry;
        carry >>= 64;
    }
    if (carry != 0)
        n->limb[n->count++] = (uint64_t)carry;
}

static natural natural_of(const tf_numeral *numeral, uint64_t *limbs)
{
    natural n = {.limb = limbs};
    uint64_t chunk = 0, power = 1;
    for (size_t i = 0; i < numeral->count; i++) {
        chunk = 10 * chunk + (uint64_t)(numeral->digit[i] - '0');
        power *= 10;
        if (power == 10000000000000000000u || i + 1 == numeral->count) {
            multiply_add(&n, power, chunk);
            chunk = 0;
            power = 1;
        }
    }
    return n;
}

//: Shift a natural number
static void shift_left(natural *n, long bits)
{
    size_t whole = (size_t)bits / 64;
    n->limb[n->count + whole] = 0;
    for (size_t i = n->count; i-- > 0;) {
        two_limbs moved = (two_limbs)n->limb[i] << bits % 64;
        n->limb[i + whole + 1] |= (uint64_t)(moved >> 64);
        n->limb[i + whole] = (uint64_t)moved;
    }
    memset(n->limb, 0, whole * sizeof *n->limb);
    n->count += whole + 1;
    drop_leading_zeros(n);
}

//: Subtract where the difference is not negative
static bool at_least(const natural *a, const natural *b)
{
    if (a->count != b->count)
        return a->count > b->count;
    size_t i = a->count;
    while (i > 0 && a->limb[i - 1] == b->limb[i - 1])
        i--;
    return i == 0 || a->limb[i - 1] > b->limb[i - 1];
}

static bool subtract_if_possible(natural *a, const natural *b)
{
    if (!at_least(a, b))
        return false;
    uint64_t borrow = 0;
    for (size_t i = 0; i < b->count; i++) {
        two_limbs difference = (two_limbs)a->limb[i] - b->limb[i] - borrow;
        a->limb[i] = (uint64_t)difference;
        borrow = (uint64_t)(difference >> 64) & 1;
    }
    if (borrow)
        a->limb[b->count]--;
    drop_leading_zeros(a);
    return true;
}

//: Divide two natural numbers, a bit at a time
/// The first 64 bits of n / d 2^63, where n and d have equally many bits.  The
/// last is also set if anything follows: enough to round by.  Destroys n.
static uint64_t leading_quotient(natural *n, const natural *d)
{
    uint64_t quotient = 0;
    for (int i = 0; i < 64; i++) {
        quotient = 2 * quotient + subtract_if_possible(n, d);
        shift_left(n, 1);
    }
    return quotient | (n->count > 0);
}

//: Round to a double, subnormal or not
/// The double nearest to bits 2^exponent.  `bits` has 63 or 64 of them.
static double round_scaled(uint64_t bits, long exponent, bool *exact)
{
    long unit = exponent + 63 - __builtin_clzll(bits) - 52;
    unit = unit > -1074 ? unit : -1074;

    // What is cut off, as a fraction of the unit in the last place: 2^-64 tail.
    long cut = unit - exponent;
    uint64_t kept = cut < 64 ? bits >> cut : 0;
    uint64_t tail = cut < 64 ? bits << (64 - cut) : cut == 64 ? bits : 1;
    const uint64_t half = (uint64_t)1 << 63;
    *exact = tail == 0;
    kept += tail > half || (tail == half && kept % 2 == 1);
    return ldexp((double)kept, (int)unit);
}

//: Divide two numerals of any length
static bool divide_long(const tf_numeral *dividend, const tf_numeral *divisor,
                        double *nearest, bool *exact)
{
    size_t digits =
        dividend->count > divisor->count ? dividend->count : divisor->count;
    size_t room = digits / 19 + 4;
    uint64_t *limbs = calloc(2 * room, sizeof *limbs);
    if (!limbs)
        return false;

    natural n = natural_of(dividend, limbs);
    natural d = natural_of(divisor, limbs + room);
    long longer = bit_length(&n) - bit_length(&d);
    if (longer > 0)
        shift_left(&d, longer);
    else
        shift_left(&n, -longer);
    *nearest = round_scaled(leading_quotient(&n, &d), longer - 63, exact);
    free(limbs);
    return true;
}

//: Round a quotient
// Of two numbers of very different length the quotient need not be computed:
// above 10^309, or below 10^-324, which is less than half the least subnormal.
static bool divide(const tf_numeral *dividend, const tf_numeral *divisor,
                   double *nearest, bool *exact)
{
    if (divide_short(dividend, divisor, nearest, exact))
        return true;
    *exact = dividend->count == 0;
    *nearest = dividend->count > divisor->count ? INFINITY : 0;
    if (*exact || dividend->count >= divisor->count + 310 ||
        divisor->count >= dividend->count + 325)
        return true;
    return divide_long(dividend, divisor, nearest, exact);
}

tf_rounding tf_rational_round(const tf_numeral *dividend,
                              const tf_numeral *divisor, double *nearest)
{
    TF_REQUIRE(divisor->count > 0);
    double size;
    bool exact;
    if (!divide(dividend, divisor, &size, &exact))
        return TF_ROUNDING_FAILED;
    if (isinf(size))
        return TF_ROUNDING_OVERFLOW;
    *nearest = dividend->negative == divisor->negative ? size : -size;
    return exact ? TF_ROUNDING_EXACT : TF_ROUNDING_NEAREST;
}
