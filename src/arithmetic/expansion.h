//: Declare expansions
#ifndef TF_ARITHMETIC_EXPANSION_H
#define TF_ARITHMETIC_EXPANSION_H

#include "arithmetic/differences.h"

//: Declare the error-free transformations
/// A real number as the sum of two doubles, hi the rounded sum.
typedef struct tf_two {
    double hi, lo;
} tf_two;

/// a + b exactly, barring overflow.
tf_two tf_two_sum(double a, double b);

/// a - b exactly, barring overflow.
tf_two tf_two_difference(double a, double b);

/// a b exactly, if |a|, |b| and |a b| are below 2^990 and the last bits set in a
/// and in b multiply to at least 2^-1074.
tf_two tf_two_product(double a, double b);

//: Declare the expansion
enum {
    TF_EXPANSION_TERMS = 24 ///< what a 3x3 determinant of doubles needs
};

/// A real number as an exact sum of doubles, smallest first, without zeros; no
/// terms: zero.  The terms do not overlap: each is a multiple of some power of
/// two above all terms before it.  So the sign is that of the last term.
typedef struct tf_expansion {
    int count;
    double term[TF_EXPANSION_TERMS];
} tf_expansion;

/// a + b: as many terms as both together at most.
void tf_expansion_add(const tf_expansion *a, const tf_expansion *b,
                      tf_expansion *sum);

/// a b: twice as many terms as a at most.
void tf_expansion_scale(const tf_expansion *a, double b, tf_expansion *product);

//: Declare the determinant of doubles
/// The n x n determinant of doubles that are zero or between 2^-300 and 2^300
/// in absolute value.
void tf_expansion_determinant(int n, double entry[TF_AXES][TF_AXES],
                              tf_expansion *determinant);

//: Close expansions
#endif
