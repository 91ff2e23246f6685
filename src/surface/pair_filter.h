//: Declare pairs of elements
#pragma once

#include "base/api.h"
#include "query/kind.h"

#include <stdbool.h>
#include <stddef.h>

/// @addtogroup surfaces
/// @{

/// Two elements of a surface that share no vertex, lent to the callback of a
/// tf_pair_filter.  Later versions may add members to its end.
typedef struct tf_element_pair {
    tf_kind kind;  ///< of what elements
    int vertex[4]; ///< of the first element, then of the second, in the order
                   ///< of a tf_surface_contact; the last is -1 in the plane
    int group[2];  ///< the group of each element; 0: it belongs to none
} tf_element_pair;

//: Declare the filter of pairs
/// Which pairs of elements may meet.  All zero: all pairs that share no vertex.
///
/// An element belongs to the group that all its vertices have, or to none if
/// they differ.  Two elements of one group never meet: they may be parts of a
/// rigid body, or a button and the cloth to which it is sewn.  The callback may
/// leave out any other pair.
typedef struct tf_pair_filter {
    size_t size;      ///< sizeof(tf_pair_filter); 0: that of version 1.0
    int vertices;     ///< how many groups are listed: one for each vertex of
                      ///< the surface; or 0
    const int *group; ///< the group of each vertex, any number; 0: none.
                      ///< NULL: there are no groups

    /// Whether two elements may meet.  Answers only by its arguments, so always
    /// the same about a pair; several threads of a tf_parallel may call it at
    /// once.  It is called for each pair that is near enough to be looked at, and
    /// must not use the surface.  NULL: all may meet that are not of one group.
    bool (*wanted)(void *context, const tf_element_pair *pair);
    void *context; ///< passed on to `wanted`
} tf_pair_filter;

/// @}
