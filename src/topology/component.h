//: Declare the parts of a surface
#pragma once

#include "surgery/state.h"

/// A search for the parts of a surface: each is a range of the list.
typedef struct tf_parts {
    tf_buffer listed; ///< of each triangle: whether it is in the list
    tf_buffer list;   ///< triangles
    int count;        ///< how many are in it
} tf_parts;

/// Begins with an empty list.  False if there is no memory; free it in any
/// case.
bool tf_parts_begin(tf_parts *parts, const tf_adaptive_surface *surface);
void tf_parts_free(tf_parts *parts);

/// Adds all triangles that are connected with one, and that one, to the list,
/// if they are not in it; returns how many.
int tf_parts_add(tf_parts *parts, const tf_adaptive_surface *surface,
                 int triangle);

static inline const int *tf_parts_list(const tf_parts *parts)
{
    return parts->list.data;
}

static inline bool tf_is_listed(const tf_parts *parts, int triangle)
{
    return ((const bool *)parts->listed.data)[triangle];
}
