// The independent judge of distances: the point nearest to the origin among the
// differences of two elements' points, found in exact rational numbers by trying
// every set of vertices, with no region, no normal and no case of degeneracy.
#ifndef SUPPORT_EXACT_DISTANCE_H
#define SUPPORT_EXACT_DISTANCE_H

#include "query/kind.h"

#include <gmp.h>

/// The square of the distance of two elements whose vertices are at x[].
void exact_distance_square(tf_kind kind, const double *const x[], mpq_t square);

/// The sign of the distance of two elements minus a length.
int exact_distance_compare(tf_kind kind, const double *const x[],
                           double length);

#endif
