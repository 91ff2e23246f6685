//: Declare two-sum
#pragma once

#include "base/environment.h"

/// A real number as the sum of two doubles, hi the rounded sum.
typedef struct tf_two {
    double hi, lo;
} tf_two;

//: Add two doubles without losing anything
/// a + b exactly, barring overflow.
static inline tf_two tf_two_sum(double a, double b)
{
    double hi = a + b;
    double b_virtual = hi - a;
    double a_virtual = hi - b_virtual;
    return (tf_two){.hi = hi, .lo = (a - a_virtual) + (b - b_virtual)};
}

/// a - b exactly, barring overflow.
static inline tf_two tf_two_difference(double a, double b)
{
    return tf_two_sum(a, -b);
}
