//: Declare how nearness is decided
#pragma once

#include "query/kind.h"

#include <stdbool.h>

/// Whether two elements at rest, whose vertices are at x[], the first element's
/// first, are nearer to each other than a distance: exact, for finite coordinates
/// and a positive finite distance.  In an IEEE environment.
bool tf_are_nearer(tf_kind kind, const double *const x[], double distance);

/// The same where rounded numbers tell: +1, they are nearer; -1, they are not; 0,
/// nothing is known.
int tf_estimate_nearer(tf_kind kind, const double *const x[], double distance);
