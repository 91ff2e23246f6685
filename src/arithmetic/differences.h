//: Declare what an arithmetic answers
#ifndef TF_ARITHMETIC_DIFFERENCES_H
#define TF_ARITHMETIC_DIFFERENCES_H

#include "spacetime/event.h"

#include <stdbool.h>

//: Declare the signs
/// The sign of a determinant.
typedef enum tf_sign {
    TF_NEGATIVE = -1,
    TF_ZERO = 0, ///< certainly zero (but see tf_report)
    TF_POSITIVE = 1,
    TF_UNKNOWN = 2, ///< any of the three
} tf_sign;

//: Declare the determinant of differences
/// The n x n determinant, n = 1, 2 or 3, with the rows to[i] - from[i] and the
/// columns axis[0..n-1]: entry (i, j) is to[i]->x[axis[j]] - from[i]->x[axis[j]]
/// as a real number, not rounded.  Every predicate of the library is one.
typedef struct tf_differences {
    int n;
    const tf_event *to[TF_AXES], *from[TF_AXES];
    int axis[TF_AXES];
} tf_differences;

//: Declare the value of a determinant
/// A real number v with |v - number 2^exponent| <= (radius + u |number|)
/// 2^exponent, u = 2^-53: besides the rounding of `number`, at most `radius`
/// off.  A zero `number` with a zero `radius` is exactly zero.
typedef struct tf_value {
    double number; ///< NaN or infinite: nothing is known
    double radius; ///< >= 0, or NaN: nothing is known
    int exponent;
    /// Zeros, but where the value is infinitely small: then it is `number`
    /// 2^exponent times the infinitesimals named here.  Among two values the one
    /// with the later order (by the first entry that differs) is infinitely
    /// smaller.
    int order[TF_AXES];
} tf_value;

//: Declare an arithmetic
/// How signs are found: an arithmetic is a value that is passed to whatever
/// needs a sign.
typedef struct tf_arithmetic {
    const char *name;
    /// Coordinates must be integers below 2^bits[axes] in absolute value, for
    /// axes = 2 and 3; 0: any finite double.
    int bits[TF_AXES + 1];
    tf_sign (*sign)(const tf_differences *differences);
    tf_value (*value)(const tf_differences *differences);
} tf_arithmetic;

//: Declare the rounded differences
/// The entries, each rounded once: the true entry times 1 + e, |e| <= u, and
/// zero only if the true one is.  Infinite where the difference overflows.
void tf_differences_round(const tf_differences *differences,
                          double entry[TF_AXES][TF_AXES]);

//: Declare the range of an arithmetic
/// Whether `arithmetic` holds the coordinate `x` of a scene with `axes` axes.
bool tf_arithmetic_holds(const tf_arithmetic *arithmetic, int axes, double x);

//: Close the differences
#endif
