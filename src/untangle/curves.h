//: Declare crossing curves
#pragma once

#include "untangle/tangle.h"

/// A point of a curve in which a surface crosses itself: where an edge passes
/// through a facet.  In the plane, where two edges cross, each passes through the
/// other.
typedef struct tf_curve_point {
    int edge, facet;
    tf_vector place;
    tf_vector normal; ///< of the facet, as its sheet turns it
    double at;        ///< how far along the edge it is, from 0 to 1
    double rise; ///< how far the edge goes along the normal: if it is positive,
                 ///< the edge's first vertex is below the facet
} tf_curve_point;

/// The points of all curves.
typedef struct tf_curves {
    size_t count;
    const tf_curve_point *point; ///< in the order of the crossings
    tf_buffer storage;
} tf_curves;

/// Lists the points of the crossings that a tangle has at x; crossings that only
/// touch have none.  False if there is no memory.
bool tf_curves_find(tf_curves *curves, const tf_tangle *tangle,
                    const double x[]);

void tf_curves_free(tf_curves *curves);
