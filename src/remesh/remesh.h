//: Declare what remeshing does
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// The operations of which remeshing is made.
typedef enum tf_operation {
    TF_SPLIT = 0, ///< of long edges
    TF_COLLAPSE,  ///< of short edges
    TF_FLIP,      ///< to better triangles
    TF_SMOOTH,    ///< a move along the surface
    TF_OPERATIONS ///< how many operations there are
} tf_operation;

/// What remeshing has done.  Lengths are as those of the positions.
typedef struct tf_remesh_report {
    int rounds; ///< so far
    /// How often an operation was tried, by its outcome; those that would make
    /// poor triangles are not even tried.
    size_t tried[TF_OPERATIONS][TF_OUTCOMES];
    /// The least quality of a triangle before, from 0, which is collinear, to 1,
    /// which is equilateral.
    double least_before;
    double least_after; ///< the same of the new surface
    double mean_before; ///< the mean quality of the triangles before
    double mean_after;  ///< the same of the new surface
    double distance; ///< the greatest from the new surface to the old one, or
                     ///< from the old one to the new, at vertices and middles
                     ///< of triangles
} tf_remesh_report;

//: Declare how to remesh
/// How to remesh.
typedef struct tf_remesh_options {
    double edge; ///< the length that edges should have, above 0
    int rounds;  ///< how often to go through all operations; 0: 5

    /// Called now and then, unless it is NULL, with what has been done so far.
    void (*progress)(void *context, const tf_remesh_report *so_far);
    void *context; ///< passed on to `progress`
} tf_remesh_options;

/// Changes a surface to triangles that are nearly equilateral, with edges of
/// about one length, and keeps its shape: its creases and its boundary, where
/// corners stay and vertices move along them, if at all, and elsewhere vertices
/// stay on the original surface, up to rounding.
///
/// Each operation is exact, and what might tangle is refused; so the new surface
/// is embedded, and the old one can be moved to it without passing through
/// itself.  Only how good the triangles are is a matter of rounding, and where
/// things are close they may stay poor.  The result is the same, to the last
/// bit, on every machine.
///
/// @param surface the surface; its gaps are closed
/// @param options how
/// @param[out] report what was done; may be NULL
/// @return TF_OK; TF_BAD_TOLERANCE if the length is not above 0 and finite, or
///     so short that there would be more triangles than numbers for their
///     corners, or if there are fewer rounds than 0; TF_BAD_ENVIRONMENT; or
///     TF_OUT_OF_MEMORY, and then the surface is still embedded
TF_API tf_status tf_adaptive_remesh(tf_adaptive_surface *surface,
                                    const tf_remesh_options *options,
                                    tf_remesh_report *report);

/// @}
