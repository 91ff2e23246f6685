//: Declare the determinant of differences
#pragma once

#include "base/environment.h"
#include "base/require.h"
#include "geometry/event.h"

/// The n x n determinant, n = 1, 2 or 3, with the rows to[i] - from[i] and the
/// columns axis[0..n-1]: entry (i, j) is the real number
/// to[i]->x[axis[j]] - from[i]->x[axis[j]], not rounded.  Every predicate of
/// the library is one.
typedef struct tf_differences {
    int n;
    const tf_event *to[TF_AXES], *from[TF_AXES];
    int axis[TF_AXES];
} tf_differences;

//: Round the differences
/// The entries, each rounded once: the true entry times 1 + e, |e| <= u, and
/// zero only if the true one is.  Infinite where the difference overflows.
static inline void tf_differences_round(const tf_differences *differences,
                                        double entry[TF_AXES][TF_AXES])
{
    const tf_differences *d = differences;
    TF_REQUIRE(d->n >= 1 && d->n <= TF_AXES);
    for (int j = 0; j < d->n; j++) {
        int k = d->axis[j];
        for (int i = 0; i < d->n; i++)
            entry[i][j] = d->to[i]->x[k] - d->from[i]->x[k];
    }
}
