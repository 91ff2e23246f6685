//: Declare what is derived from a mesh
#pragma once

#include "base/error.h"
#include "surface/elements.h"
#include "surface/mesh.h"

/// Whether a mesh is good: TF_OK; TF_BAD_AXES; TF_BAD_COUNT if a count is
/// negative, if there are elements without a list, or if an int cannot count all
/// coordinates or all edges; TF_NO_ELEMENTS; or TF_BAD_INDEX.
tf_status tf_mesh_check(const tf_mesh *mesh, tf_error *error);

/// Lists the triangles of a good mesh, each once.  False if there is no memory.
bool tf_mesh_triangles(const tf_mesh *mesh, tf_elements *list,
                       tf_sort_workspace *workspace);

/// Lists the edges of these triangles and the other edges, each once.
bool tf_mesh_edges(const tf_mesh *mesh, const tf_elements *triangles,
                   tf_elements *list, tf_sort_workspace *workspace);
