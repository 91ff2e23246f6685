//: Declare the gradient of a curve's length
#pragma once

#include "untangle/change.h"
#include "untangle/curves.h"

/// Proposes to move the edge and the facet of a curve's point such that the curve
/// shortens: by the gradient of its length, a quarter of the mean edge at most.
/// It needs no side, and works where the curve cuts nothing.  In the plane the edge
/// moves along the other edge, towards the nearer end of that.
void tf_shorten_curve(tf_change *change, const tf_tangle *tangle,
                      const double x[], const tf_curve_point *point);
