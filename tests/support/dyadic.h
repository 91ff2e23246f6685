// A double is an integer times a power of two: exact integers for the oracle.
#ifndef SUPPORT_DYADIC_H
#define SUPPORT_DYADIC_H

#include <gmp.h>

/// The exponent of the lowest bit set in the finite `x`; INT_MAX for zero.
int dyadic_exponent(double x);

/// The lesser of `least` and the exponent of `x`.
int dyadic_least(int least, double x);

/// scaled = x / 2^exponent, with `exponent` at most that of `x`, if not zero.
void dyadic_scale(mpz_t scaled, double x, int exponent);

#endif
