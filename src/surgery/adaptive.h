//: Declare adaptive surfaces
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "surface/mesh.h"
#include "surgery/defects.h"

#include <stddef.h>

/// @defgroup adaptive Adaptive surfaces
/// Surfaces whose triangles are split, collapsed, flipped and moved, and that
/// never intersect themselves, exactly.
/// @{

/// An embedded surface that operations change: each vertex has triangles all
/// around it, or is on the boundary.  Parts that are not so may be left alone
/// (tf_adaptive_create_around).  Only one thread at a time may use it.
typedef struct tf_adaptive_surface tf_adaptive_surface;

//: Declare how adaptive surfaces are made
/// Makes an adaptive surface of a mesh in space, which it copies.  It is
/// refused, never mended, unless each edge has two triangles, which pass it in
/// opposite directions, or one; the triangles at each vertex form one ring or
/// one fan; none is collinear; and the surface does not intersect or touch
/// itself.  All this is tested exactly.  A vertex without triangles stays
/// without, and hinders nothing.
///
/// @param mesh its triangles; there must be no other edges
/// @param position three coordinates a vertex
/// @param[out] surface the surface, to be freed by tf_adaptive_free; set only
///     with TF_OK
/// @param[out] error the first that is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_AXES; TF_BAD_COUNT; TF_NO_ELEMENTS; TF_BAD_INDEX;
///     TF_NOT_FINITE; TF_EDGE_NOT_MANIFOLD about an edge of no triangle, or
///     about the second triangle that passes an edge in one direction, with the
///     ends of that edge; TF_VERTEX_NOT_MANIFOLD; TF_COLLINEAR; TF_NOT_EMBEDDED
///     about a pair; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY
TF_API tf_status tf_adaptive_create(const tf_mesh *mesh,
                                    const double position[],
                                    tf_adaptive_surface **surface,
                                    tf_error *error);

/// Frees a surface, and all that it lent.
/// @param surface the surface; may be NULL
TF_API void tf_adaptive_free(tf_adaptive_surface *surface);

//: Declare surfaces with defects
/// Makes an adaptive surface of a mesh that need not be perfect.  First,
/// triangles are turned over, the fewest that it takes, so that two on an edge
/// pass it in opposite directions, if the surface has two sides.  Then the
/// vertices of all defects are left alone: the ends of an edge that two
/// triangles pass in one direction, or more than two; a vertex whose triangles
/// form more than one ring or fan; and all corners of a collinear triangle, and
/// of the triangles of two elements that intersect or touch.
///
/// No operation moves or removes such a vertex, nor touches an edge between two
/// of them: it is TF_IMPOSSIBLE.  So triangles that intersect stay as they are,
/// and no others ever do.  All promises about adaptive surfaces hold for the
/// rest; for example, no motion makes two triangles meet that did not before.
/// tf_flow_step refuses such a surface.
///
/// @param mesh its triangles; there must be no other edges
/// @param position three coordinates a vertex
/// @param[out] surface the surface, to be freed by tf_adaptive_free; set only
///     with TF_OK
/// @param[out] defects what is wrong, lent until the surface is freed, with the
///     numbers of the mesh; set only with TF_OK; may be NULL
/// @param[out] error what makes it impossible, if anything; may be NULL
/// @return TF_OK; TF_BAD_AXES; TF_BAD_COUNT; TF_NO_ELEMENTS; TF_BAD_INDEX;
///     TF_NOT_FINITE; TF_EDGE_NOT_MANIFOLD about an edge of no triangle;
///     TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY
TF_API tf_status tf_adaptive_create_around(const tf_mesh *mesh,
                                           const double position[],
                                           tf_adaptive_surface **surface,
                                           const tf_defects **defects,
                                           tf_error *error);

//: Declare what an adaptive surface lends
/// The triangles of a surface as it is now.  The numbers of vertices and
/// triangles stay the same while they exist; the first vertex of a triangle that
/// is gone is -1, and a vertex that is gone belongs to no triangle.
/// @param surface the surface
/// @return the mesh, lent until a call changes the surface: until an operation
///     is committed, or any other function that may change it returns TF_OK
TF_API const tf_mesh *tf_adaptive_mesh(const tf_adaptive_surface *surface);

/// The positions of its vertices.
/// @param surface the surface
/// @return three coordinates each, lent until a call changes the surface
TF_API const double *tf_adaptive_positions(const tf_adaptive_surface *surface);

/// Returns how much memory a surface holds by now.
/// @param surface the surface
/// @return bytes
TF_API size_t tf_adaptive_memory(const tf_adaptive_surface *surface);

//: Declare how the gaps are closed
/// Gives vertices and triangles new numbers without gaps, in the same order.
/// Vertices without triangles are dropped, too.
/// @param surface the surface
/// @param[out] map the new number of each vertex, or -1 for one that is gone;
///     room for all of them; may be NULL
/// @return TF_OK or TF_OUT_OF_MEMORY, and then nothing is changed
TF_API tf_status tf_adaptive_compact(tf_adaptive_surface *surface, int map[]);

/// @}
