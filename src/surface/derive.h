//: Declare what is derived from a mesh
#pragma once

#include "base/status.h"
#include "surface/elements.h"
#include "surface/mesh.h"

/// Whether a mesh is good: TF_OK; TF_NO_ELEMENTS; TF_BAD_INDEX; or
/// TF_OUT_OF_MEMORY if it has too many elements for an int to count.
tf_status tf_mesh_check(const tf_mesh *mesh, tf_flaw *flaw);

/// Lists the triangles of a good mesh, each once.  False if there is no memory.
bool tf_mesh_triangles(const tf_mesh *mesh, tf_elements *list,
                       tf_sort_workspace *workspace);

/// Lists the edges of these triangles and the other edges, each once.
bool tf_mesh_edges(const tf_mesh *mesh, const tf_elements *triangles,
                   tf_elements *list, tf_sort_workspace *workspace);
