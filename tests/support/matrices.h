// Determinants to try: matrices of differences, made at random to be hard.
#ifndef SUPPORT_MATRICES_H
#define SUPPORT_MATRICES_H

#include "arithmetic/differences.h"
#include "support/support.h"

/// An n x n matrix with the rows to[i] - from[i].
typedef struct matrix {
    int n;
    tf_event to[TF_AXES], from[TF_AXES];
    int axis[TF_AXES];
} matrix;

/// The zero matrix.  The axes come in any order, and those that it does not use
/// are NaN.
matrix matrix_new(generator *random, int n);

/// The matrix of the entries given row by row, less zeros.
matrix matrix_of(int n, const double entry[]);

/// Its determinant, which refers to it.
tf_differences matrix_differences(const matrix *m);

/// How many coordinates it has, and the i-th: row by row, of each entry the
/// minuend and the subtrahend.
int matrix_size(const matrix *m);
double *matrix_coordinate(matrix *m, int i);

/// Fail the test, showing the matrix, unless `good`.
void expect_of_matrix(bool good, const char *what, const matrix *m);

/// Coordinates from 0, 1, ..., values - 1.
matrix matrix_lattice(generator *random, int n, int values);

/// The last row is a sum of multiples of the others, but for rounding.
matrix matrix_flat(generator *random, int n);

/// The same without rounding.  In every other the differences are doubles.
matrix matrix_singular(generator *random, int n);

/// Magnitudes from 4.9e-324 to 1.7e308, few in a matrix.
matrix matrix_extreme(generator *random, int n);

/// All finite doubles, by bit pattern.
matrix matrix_bits(generator *random, int n);

/// One of the above.
matrix matrix_any(generator *random, int n);

/// Move each coordinate by -ulps..ulps units in the last place.
void matrix_nudge(generator *random, matrix *m, int ulps);

/// Multiply the j-th column by 2^exponent.
void matrix_scale(matrix *m, int j, int exponent);

/// A finite double of a random bit pattern.
double any_double(generator *random);

/// Count up through -1, 0 and 1, the first first; false after the last, which
/// starts again.
bool next_signs(int count, double sign[]);

#endif
