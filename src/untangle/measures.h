//: Declare the measures of an untangling
#pragma once

#include "untangle/options.h"
#include "untangle/tangle.h"

/// Measures what an untangling has done, which ends at x, of the same scale as
/// the tangle, of which 2^power is the unit: sets the members of the report
/// from `moved` on, but for `found`.  False if there is no memory.
bool tf_measure(const tf_tangle *tangle, const double x[], int power,
                tf_untangle_report *report);

/// The root of the mean of the squares of the distances from `in`, over all
/// vertices.
double tf_deviation(const tf_tangle *tangle, const double x[]);
