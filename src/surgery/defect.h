//: Declare what is wrong with a mesh
#pragma once

#include "base/api.h"
#include "surface/check.h"

/// @addtogroup adaptive
/// @{

/// Where a mesh is no adaptive surface.  What a status is not about is -1.
typedef struct tf_defect {
    int triangle;         ///< in the list that the caller gave
    int vertex[2];        ///< a vertex, or the two of an edge
    tf_crossing crossing; ///< with TF_NOT_EMBEDDED: the elements
} tf_defect;

/// @}
