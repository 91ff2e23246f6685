// Numbers as sums of doubles that do not overlap, and determinants of them: the
// classical way to exact signs, which the superaccumulator is timed against.
#ifndef FIG_EXPANSION_H
#define FIG_EXPANSION_H

#include "arithmetic/sign.h"
#include "arithmetic/two_sum.h"

/// a b exactly, if |a|, |b| and |a b| are below 2^990 and the last bits set in a
/// and in b multiply to at least 2^-1074.
tf_two two_product(double a, double b);

enum {
    EXPANSION_TERMS = 24 ///< what a 3x3 determinant of doubles needs
};

/// A real number as an exact sum of doubles, smallest first, without zeros; no
/// terms: zero.  The terms do not overlap: each is a multiple of some power of
/// two above all terms before it.  So the sign is that of the last term.
typedef struct expansion {
    int count;
    double term[EXPANSION_TERMS];
} expansion;

/// a + b in a third expansion: as many terms as both together at most.
void expansion_add(const expansion *a, const expansion *b, expansion *sum);

/// a b: twice as many terms as a at most.
void expansion_scale(const expansion *a, double b, expansion *product);

/// The n x n determinant of doubles that are zero or between 2^-300 and 2^300
/// in absolute value.
void expansion_determinant(int n, double entry[TF_AXES][TF_AXES],
                           expansion *determinant);

/// The sign of an expansion.
tf_sign expansion_sign(const expansion *e);

#endif
