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

/// Candidates of a step: pairs of elements that share no vertex and may meet
/// (tf_surface_set_filter).  Every such pair that touches during the step is
/// among them, in space-time and in linear motion, and few others are: pairs
/// whose boxes are not apart.  Boxes are around the elements at the start and at
/// the end, or where motions are small, around all that they sweep; they are
/// rounded, in a way that loses no pair and adds some that nearly touch.
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
/// @param options of these the threads, the progress and the zones are used;
///     NULL: all zero
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
