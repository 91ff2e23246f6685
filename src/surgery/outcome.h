//: Declare the outcomes of an operation
#pragma once

#include "base/api.h"

/// @addtogroup adaptive
/// @{

/// What became of an operation on a surface.  One that is refused has changed
/// nothing.
typedef enum tf_outcome {
    TF_NO_OUTCOME = 0,  ///< it failed, with a status other than TF_OK
    TF_COMMITTED,       ///< it is done
    TF_IMPOSSIBLE,      ///< no surface would be left, or there is no such
                        ///< element
    TF_FLATTENED,       ///< a new triangle would be collinear
    TF_OVERLAPPED,      ///< a new triangle would touch another one
    TF_PASSED_VERTEX,   ///< a vertex would be swept over
    TF_PASSED_EDGE,     ///< an edge would be swept over
    TF_PASSED_TRIANGLE, ///< the vertex that moves would pass through a triangle
    TF_OUTCOMES         ///< how many outcomes there are
} tf_outcome;

/// @}
