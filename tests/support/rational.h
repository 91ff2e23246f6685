// An arithmetic with exact signs that shares nothing with the library's: for
// the tests of what comes before the exact arithmetic.
#ifndef SUPPORT_RATIONAL_H
#define SUPPORT_RATIONAL_H

#include "arithmetic/arithmetic.h"
#include "arithmetic/differences.h"
#include "arithmetic/sign.h"

#include <gmp.h>

/// determinant 2^(the result) is that of the differences, exactly.
int rational_determinant(mpz_t determinant, const tf_differences *differences);

/// Whether `value` is integer 2^exponent rounded to nearest, with no other
/// error.
bool rational_is(const mpz_t integer, int exponent, tf_value value);

/// Signs of determinants of integers of any length, of all finite doubles.
/// Values are rounded to nearest, with no other error.
extern const tf_arithmetic oracle_arithmetic;

#endif
