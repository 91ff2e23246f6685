// An arithmetic with exact signs that shares nothing with the library's: for
// the tests of what comes before the exact arithmetic.
#ifndef SUPPORT_RATIONAL_H
#define SUPPORT_RATIONAL_H

#include "arithmetic/differences.h"

/// Signs of determinants of integers of any length, of all finite doubles.
/// Values are rounded to nearest, with no other error.
extern const tf_arithmetic oracle_arithmetic;

#endif
