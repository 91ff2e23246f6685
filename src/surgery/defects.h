//: Declare the defects of a mesh
#pragma once

#include "base/api.h"
#include "base/error.h"

#include <stddef.h>

/// @addtogroup adaptive
/// @{

/// What is wrong with a mesh, and what a surface leaves alone because of that.
/// Later versions may add to its end.
typedef struct tf_defects {
    size_t count;           ///< how many defects there are
    const tf_error *defect; ///< each as tf_adaptive_create tells of the first:
                            ///< edges, vertices, collinear triangles, pairs
    int turned;             ///< triangles whose last two corners were exchanged
    int vertices;           ///< how many are left alone
    int triangles;          ///< how many have three such vertices
} tf_defects;

/// @}
