//: Declare accumulated determinants
#pragma once

#include "arithmetic/differences.h"
#include "arithmetic/sign.h"

/// The sign and the value of a determinant, exact for any finite doubles: the
/// sum of its products in a superaccumulator, rounded once for the value.
tf_sign tf_accumulated_sign(const tf_differences *differences);
tf_value tf_accumulated_value(const tf_differences *differences);
