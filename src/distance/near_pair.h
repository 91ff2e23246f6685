//: Declare near pairs
#pragma once

#include "base/api.h"
#include "query/kind.h"

#include <stddef.h>

/// @addtogroup distances
/// @{

/// Two elements of a surface that are nearer to each other than a length.
typedef struct tf_near_pair {
    tf_kind kind;  ///< of what elements
    int vertex[4]; ///< theirs, in the order of a tf_surface_contact
} tf_near_pair;

/// All near pairs of a surface.
typedef struct tf_near_pairs {
    size_t count;             ///< how many
    const tf_near_pair *pair; ///< sorted by kind, then by vertices
} tf_near_pairs;

/// @}
