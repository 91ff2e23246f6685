//: Declare the conditions of an adaptive surface
#pragma once

#include "base/error.h"
#include "surgery/adaptive_surface.h"

/// Whether a mesh has triangles and nothing else, with good indices, and all
/// its vertices have finite positions.  Sets an error to what it returns: TF_OK
/// or what is wrong with the mesh.
tf_status tf_check_mesh(const tf_mesh *mesh, const double position[],
                        tf_error *error);

/// What is told of each defect of a surface.  Returns TF_OK if it wants to be
/// told of the next one, or what ends the search.
typedef struct tf_defect_sink tf_defect_sink;
struct tf_defect_sink {
    tf_status (*take)(tf_defect_sink *sink, const tf_error *defect);
};

/// Finds the edges that a triangle passes as another one does, each once
/// (TF_EDGE_NOT_MANIFOLD); then the vertices whose triangles form more than one
/// ring or fan, but for those that are frozen (TF_VERTEX_NOT_MANIFOLD); the
/// collinear triangles (TF_COLLINEAR); and the pairs that intersect or touch
/// (TF_NOT_EMBEDDED).  Returns TF_OK, what the sink did, or any other status of
/// the check of surfaces, to which the error is set.
/// @param mesh of which the surface was made
tf_status tf_find_defects(const tf_adaptive_surface *surface,
                          const tf_mesh *mesh, tf_defect_sink *sink,
                          tf_error *error);

/// Whether there are none.  Sets an error to what it returns: TF_OK, or the
/// status of the first one, or that of the check.
tf_status tf_check_surface(const tf_adaptive_surface *surface,
                           const tf_mesh *mesh, tf_error *error);
