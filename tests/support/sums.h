// Exact sums of products of three doubles, for tests of what claims to be exact
// or to know its error.
#ifndef SUPPORT_SUMS_H
#define SUPPORT_SUMS_H

#include "arithmetic/differences.h"
#include "arithmetic/sign.h"

#include <gmp.h>

/// Sums are integers in units of 2^SUM_EXPONENT, of which all products of three
/// doubles are multiples.
enum {
    SUM_EXPONENT = -3222
};

/// sum += a b c.
void sum_add(mpz_t sum, double a, double b, double c);

/// sum = the determinant.
void sum_determinant(mpz_t sum, const tf_differences *differences);

/// Whether hi + lo is the sum, and hi the double nearest to it.
bool sum_is(const mpz_t sum, double hi, double lo);

/// The sign of the sum.
tf_sign sum_sign(const mpz_t sum);

#endif
