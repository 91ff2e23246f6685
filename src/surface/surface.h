//: Declare the surface
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "surface/mesh.h"
#include "surface/pair_filter.h"

#include <stddef.h>

/// @addtogroup surfaces
/// @{

/// A surface whose vertices can be given positions, step after step.  It keeps
/// its memory from one step to the next: for large surfaces about 190 bytes per
/// triangle if triangles share their vertices, up to about 410 if each has its
/// own, and what is found.  One thread at a time may use it.
typedef struct tf_surface tf_surface;

/// Makes a surface of a mesh, which it copies.
///
/// @param mesh the elements
/// @param[out] surface the surface, to be freed by tf_surface_free; set only
///     with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_AXES, also for triangles in the plane; TF_BAD_COUNT if
///     a count is negative, or its list missing, or so large that an int cannot
///     count all coordinates or edges; TF_NO_ELEMENTS if there are neither
///     triangles nor edges;
///     TF_BAD_INDEX if an element repeats an index or has that of no vertex; or
///     TF_OUT_OF_MEMORY
TF_API tf_status tf_surface_create(const tf_mesh *mesh, tf_surface **surface,
                                   tf_error *error);

/// Frees a surface, and all that it lent.
/// @param surface the surface; may be NULL
TF_API void tf_surface_free(tf_surface *surface);

//: Declare the size of a surface
/// The number of coordinates of a position.
/// @param surface the surface
/// @return 3 for a surface in space, 2 for a curve in the plane
TF_API int tf_surface_axes(const tf_surface *surface);

/// The number of vertices of a surface, particles included.
/// @param surface the surface
/// @return how many positions a motion of the surface has
TF_API int tf_surface_vertices(const tf_surface *surface);

//: Declare the edges of a surface
/// The edges of a surface, each once: those of its triangles and the others.
/// @param surface the surface
/// @param[out] count how many there are
/// @return the vertices of each, the one with the lower index first; sorted, and
///     lent until the surface is freed
TF_API const int *tf_surface_edges(const tf_surface *surface, int *count);

/// The triangles of a surface, each once.
/// @param surface the surface
/// @param[out] count how many there are
/// @return the vertices of each in increasing order; sorted, and lent until the
///     surface is freed
TF_API const int *tf_surface_triangles(const tf_surface *surface, int *count);

//: Declare how pairs are left out
/// Says which pairs of a surface's elements may meet.  What the filter leaves out
/// does not exist for later calls: it is no candidate, no contact and no
/// intersection, and a resolved step may make it meet.
///
/// The guarantees hold for what is kept.  No pair that is kept has a contact in a
/// resolved step.  An edge and a triangle that start a step without contacts
/// apart end it apart if their five pairs are kept: each end of the edge with the
/// triangle, and the edge with each edge of the triangle.  (Groups leave out one
/// of these only if four of the five vertices have the same group.)  In the plane
/// so do two edges if their four pairs of a vertex and an edge are kept.  A
/// vertex that is kept with all triangles of a closed surface stays inside or
/// outside, and two loops of edges, each of which is kept with all of the other
/// loop, stay linked as they are.
///
/// @param surface the surface
/// @param filter which pairs, copied with its groups; NULL: all that share no
///     vertex
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if there are groups, but not one for each vertex,
///     or a number of groups without the groups; TF_BAD_OPTION; or
///     TF_OUT_OF_MEMORY.  Unless it is TF_OK, the filter stays as it was
TF_API tf_status tf_surface_set_filter(tf_surface *surface,
                                       const tf_pair_filter *filter,
                                       tf_error *error);

//: Declare the memory of a surface
/// How much memory a surface holds by now.
/// @param surface the surface
/// @return bytes
TF_API size_t tf_surface_memory(const tf_surface *surface);

/// @}
