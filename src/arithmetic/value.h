//: Declare how values are scaled
#pragma once

#include "arithmetic/sign.h"

/// Divides values by one power of two, so that the largest comes near 1, and
/// leaves them with the exponent and the order zero: an infinitely smaller one
/// becomes zero.  Where digits fall below the least double, a radius that is
/// not zero grows by it.  Values that are not known stay NaN or infinite; if
/// all others are certainly zero, all stay as they are.
void tf_values_scale(int count, tf_value value[]);
