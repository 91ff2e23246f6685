//: Declare the conditions of an adaptive surface
#pragma once

#include "surgery/adaptive_surface.h"
#include "surgery/defect.h"

/// Whether a mesh has triangles and nothing else, with good indices, and all
/// its vertices have finite positions.  Returns TF_OK or what is wrong with it.
tf_status tf_check_mesh(const tf_mesh *mesh, const double position[],
                        tf_defect *defect);

/// Whether each edge of a surface has two triangles, in opposite directions, or
/// one, and the triangles of each vertex form one ring or one fan.  Returns
/// TF_OK, TF_EDGE_NOT_MANIFOLD or TF_VERTEX_NOT_MANIFOLD, with the first defect.
tf_status tf_check_manifold(const tf_adaptive_surface *surface,
                            tf_defect *defect);

/// Whether a mesh at rest has no collinear triangle and does not intersect or
/// touch itself.  Returns TF_OK, TF_COLLINEAR, TF_NOT_EMBEDDED, or any other
/// status of the check of surfaces, with the first defect.
tf_status tf_check_embedding(const tf_adaptive_surface *surface,
                             const tf_mesh *mesh, const double position[],
                             tf_defect *defect);
