//: Declare polynomials over the step
#pragma once

#include <stdbool.h>

enum {
    TF_MOST_COEFFICIENTS = 4, ///< of a cubic
    TF_MOST_CUTS = 4          ///< both ends and two extrema
};

/// A quadratic or cubic on [0, 1] in Bernstein form: its values there are
/// between the least and the greatest coefficient, the first and the last of
/// which are its values at 0 and 1.
typedef struct tf_polynomial {
    int degree; ///< 2 or 3
    double coefficient[TF_MOST_COEFFICIENTS];
} tf_polynomial;

/// The value at a time of the step.
double tf_polynomial_value(const tf_polynomial *p, double t);

//: Declare the roots between extrema
/// The times that cut [0, 1] into pieces on which the polynomial is monotone,
/// but for rounding: 0, its extrema in increasing order, 1.  Returns how many.
int tf_polynomial_cuts(const tf_polynomial *p, double cut[TF_MOST_CUTS]);

/// The root between two times at which the values have opposite strict signs,
/// as far as rounded values show where it is.
double tf_polynomial_root(const tf_polynomial *p, double lo, double hi);

//: Declare what coefficients tell
/// Whether the value can be within `reach` of zero on [0, 1].
bool tf_polynomial_can_reach(const tf_polynomial *p, double reach);

/// Whether all coefficients are zero.
bool tf_polynomial_is_zero(const tf_polynomial *p);
