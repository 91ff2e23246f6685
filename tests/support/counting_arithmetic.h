// An arithmetic that counts what is asked of it.
#ifndef SUPPORT_COUNTING_ARITHMETIC_H
#define SUPPORT_COUNTING_ARITHMETIC_H

#include "arithmetic/arithmetic.h"

typedef struct evaluations {
    int signs, values;
} evaluations;

/// An arithmetic that answers as `arithmetic` does, and counts from zero.  One
/// at a time.
tf_arithmetic counting(const tf_arithmetic *arithmetic);

/// What was asked since.
evaluations counted(void);

#endif
