//: Declare patches and their level
#pragma once

#include "remesh/measure.h"

/// Triangles that are to be replaced by those between their outline and one
/// vertex, the apex.  The volume that a surface encloses is then a linear
/// function of the position of the apex, so that the positions at which none is
/// gained or lost form a plane: the level of the patch.
typedef struct tf_patch {
    tf_vector apex;
    tf_vector normal; ///< the sum of the normals, which the outline determines
    double below;     ///< by how much the apex is below the level: the volume
                      ///< that would be lost, times 6
} tf_patch;

/// Adds a triangle to a patch, which begins with an apex and nothing else.
void tf_patch_add(tf_patch *patch, const tf_shape *shape);

/// The star of a vertex, as a patch with this apex.
tf_patch tf_patch_of_star(const tf_adaptive_surface *surface, int vertex,
                          tf_vector apex);

/// The position nearest to the apex at which 1/6 of `more` is gained.
tf_vector tf_patch_position(const tf_patch *patch, double more);
