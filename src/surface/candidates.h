//: Declare candidates
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "query/motion.h"
#include "surface/candidate.h"
#include "surface/contacts.h"
#include "surface/surface.h"

#include <stddef.h>

/// @addtogroup surfaces
/// @{

/// All candidates of a step: the pairs of elements that share no vertex, may meet
/// (tf_surface_set_filter), and whose boxes, around all that they sweep,
/// overlap.  Boxes are rounded, in a way that keeps all overlaps and makes some
/// of boxes that nearly touch.
typedef struct tf_candidates {
    size_t point_count;         ///< how many with a vertex
    const tf_candidate *points; ///< a vertex, and in space a triangle by its
                                ///< place in tf_surface_triangles, in the plane
                                ///< an edge by that in tf_surface_edges
    size_t edge_count;          ///< how many of two edges
    const tf_candidate *edges;  ///< two edges, by their places in
                                ///< tf_surface_edges; none in the plane
} tf_candidates;

/// Finds the candidates of a step, for a narrow phase of your own;
/// tf_surface_detect finds the contacts themselves, in less memory.
///
/// @param surface the surface
/// @param motion its vertices at the start and the end of the step
/// @param options of these the threads and the progress are used; NULL: all
///     zero
/// @param[out] found the candidates, lent until the next call for this surface,
///     in the same order for any number of threads; set only with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_OPTION; TF_NOT_FINITE;
///     TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or TF_CANCELLED
TF_API tf_status tf_surface_candidates(tf_surface *surface,
                                       const tf_motion *motion,
                                       const tf_detect_options *options,
                                       tf_candidates *found, tf_error *error);

/// @}
