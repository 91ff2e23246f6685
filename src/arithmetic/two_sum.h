//: Declare two-sum
#ifndef TF_ARITHMETIC_TWO_SUM_H
#define TF_ARITHMETIC_TWO_SUM_H

/// A real number as the sum of two doubles, hi the rounded sum.
typedef struct tf_two {
    double hi, lo;
} tf_two;

/// a + b exactly, barring overflow.
tf_two tf_two_sum(double a, double b);

/// a - b exactly, barring overflow.
tf_two tf_two_difference(double a, double b);

#endif
