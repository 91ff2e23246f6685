//: Declare the conditions of an adaptive surface
#pragma once

#include "base/error.h"
#include "surgery/adaptive_surface.h"

/// Whether a mesh has triangles and nothing else, with good indices, and all
/// its vertices have finite positions.  Each check sets an error to what it
/// returns: here TF_OK or what is wrong with the mesh.
tf_status tf_check_mesh(const tf_mesh *mesh, const double position[],
                        tf_error *error);

/// Whether each edge of a surface has two triangles, in opposite directions, or
/// one, and the triangles of each vertex form one ring or one fan.  Returns
/// TF_OK, TF_EDGE_NOT_MANIFOLD or TF_VERTEX_NOT_MANIFOLD, about the first one.
tf_status tf_check_manifold(const tf_adaptive_surface *surface,
                            tf_error *error);

/// Whether a mesh at rest has no collinear triangle and does not intersect or
/// touch itself.  Returns TF_OK, TF_COLLINEAR, TF_NOT_EMBEDDED, or any other
/// status of the check of surfaces, about the first one.
tf_status tf_check_embedding(const tf_adaptive_surface *surface,
                             const tf_mesh *mesh, const double position[],
                             tf_error *error);
