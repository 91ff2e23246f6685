// The exact truth of linear motion: whether two elements all of whose points
// move in straight lines meet, and when first.  Found by isolating the real
// roots of integer polynomials; shares nothing with the library.
#ifndef SUPPORT_LINEAR_TRUTH_H
#define SUPPORT_LINEAR_TRUTH_H

#include <stdbool.h>

/// Whether two elements meet in [0, 1]; if so `*toi` is within 2^-52 of the
/// earliest time.  The coordinates of `axes + 1` vertices, those of the first
/// element (1 or 2) first, are any finite doubles, however degenerate.
bool linear_truth(int axes, int vertices, const double start[],
                  const double end[], double *toi);

#endif
