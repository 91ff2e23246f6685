//: Declare a candidate
#pragma once

#include "base/api.h"

/// @addtogroup surfaces
/// @{

/// Two elements that may touch during a step.
typedef struct tf_candidate {
    int first;  ///< its place in the list of its kind
    int second; ///< that of the other
} tf_candidate;

/// @}
