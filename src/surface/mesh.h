//: Declare meshes
#pragma once

#include "base/api.h"

/// @addtogroup surfaces Surfaces
/// @{

/// The elements of a surface in space or a curve in the plane, borrowed from
/// the caller.
///
/// An edge or triangle is given by the indices of its vertices, which must be
/// distinct, and there must be at least one of these; all else is legal.  Any
/// number of triangles may share an edge, the surface may have many parts,
/// vertices may lie in one place and triangles have no area, and an element may
/// be listed twice.  A vertex of no element is a particle, and takes part as a
/// point.
typedef struct tf_mesh {
    int axes;            ///< 3 for a surface in space, 2 for a curve in the
                         ///< plane
    int vertices;        ///< how many
    int triangles;       ///< how many; none in the plane
    const int *triangle; ///< three indices each
    int edges;           ///< how many edges besides those of the triangles:
                         ///< in space for example of rods, in the plane all
    const int *edge;     ///< two indices each
} tf_mesh;

/// @}
