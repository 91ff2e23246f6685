//: Declare how to resolve a step
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "response/options.h"
#include "response/resolver.h"

/// @addtogroup response
/// @{

/// Changes the end of a step as little as it can such that no two elements meet
/// on the way.
///
/// With TF_OK each vertex and triangle and any two edges, in the plane each
/// vertex and edge, that share no vertex are apart at all times of the stored
/// step, its ends included, and exactly so.  So the end is free of
/// intersections, is a legal next start, and nothing has passed through
/// anything.  It always ends, with such an end.  A step without contacts comes
/// back bit for bit, and of others all that had not to be moved.
///
/// Vertices of inverse mass 0 end where they should, bit for bit, unless there
/// is no other way but to hold them back: two plates closing upon a sheet.
///
/// The same bits for any number of threads.
///
/// @param resolver the resolver of the surface
/// @param vertices how many vertices have positions
/// @param start where they start, `axes` coordinates each; free of intersections
///     (tf_surface_check) and of touching
/// @param[in,out] end in: where they should end, as any simulation proposes;
///     out, only with TF_OK: where they end
/// @param inverse_mass of each vertex, 0 or more; 0: it should not be moved;
///     NULL: 1 for all
/// @param options how to respond; NULL: all zero
/// @param[out] report what it took; set only with TF_OK; may be NULL
/// @param[out] obstacle what is wrong where the status is not TF_OK; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the surface has another number of vertices;
///     TF_NOT_FINITE; TF_BAD_MASS; TF_BAD_TOLERANCE if an option is not in its
///     range; TF_START_NOT_CLEAR; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY
TF_API tf_status tf_step_resolve(tf_resolver *resolver, int vertices,
                                 const double start[], double end[],
                                 const double inverse_mass[],
                                 const tf_response_options *options,
                                 tf_response_report *report,
                                 tf_obstacle *obstacle);

/// @}
