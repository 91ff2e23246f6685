//: Declare nearest points of two elements
#pragma once

#include "base/api.h"

/// @defgroup distances Distances
/// How far apart elements at rest are.
/// @{

/// Where two elements are nearest to each other, and how far apart they are.
typedef struct tf_nearest {
    double lower; ///< the distance is at least this
    double upper; ///< and at most this, which is a few units in the last place
                  ///< more; both are 0 if it is 0
    double barycentric[2][3]; ///< of a nearest point of the first and of the
                              ///< second element, by their vertices as given:
                              ///< each at least 0, the sum of each element's 1
                              ///< up to rounding; unused ones are zero
} tf_nearest;

/// @}
