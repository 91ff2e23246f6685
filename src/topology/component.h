//: Declare the components of a surface
#pragma once

#include "surgery/adaptive_surface.h"

/// A search for the components of a surface: each is a range of the list.
typedef struct tf_components {
    tf_buffer listed; ///< of each triangle: whether it is in the list
    tf_buffer list;   ///< triangles
    int count;        ///< how many are in it
} tf_components;

/// Begins with an empty list.  False if there is no memory; free it in any
/// case.
bool tf_components_begin(tf_components *components,
                         const tf_adaptive_surface *surface);
void tf_components_free(tf_components *components);

/// Adds all triangles that are connected with one, and that one, to the list,
/// if they are not in it; returns how many.  If the call whose draft the surface
/// is gets cancelled, some may be missing.
int tf_components_add(tf_components *components,
                      const tf_adaptive_surface *surface, int triangle);

static inline const int *tf_components_list(const tf_components *components)
{
    return components->list.data;
}

static inline bool tf_is_listed(const tf_components *components, int triangle)
{
    return ((const bool *)components->listed.data)[triangle];
}
