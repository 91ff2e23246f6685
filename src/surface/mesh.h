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

//: Declare what may be wrong with a surface
/// The kinds of elements.
typedef enum tf_element {
    TF_NO_ELEMENT = 0, ///< none
    TF_VERTEX,         ///< a vertex
    TF_EDGE,           ///< an edge of no triangle
    TF_TRIANGLE,       ///< a triangle
} tf_element;

/// What a status other than TF_OK is about, as far as it is about one element.
typedef struct tf_flaw {
    tf_element element; ///< TF_NO_ELEMENT: about none
    int index;          ///< which one, in the list that the caller gave
    int vertex;         ///< the index that is bad, or the vertex
} tf_flaw;

/// @}
