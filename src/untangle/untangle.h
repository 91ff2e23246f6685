//: Declare how to untangle a surface
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "response/resolver.h"
#include "surface/check.h"
#include "untangle/options.h"

/// @addtogroup untangling
/// @{

/// Moves vertices of a surface that intersects itself such that it does not,
/// and ends near where they were.
///
/// First the rungs before TF_RUNG_RETURN look for any clear state, in which the
/// surface has no intersections, as tf_surface_check finds them.  From there
/// tf_step_resolve carries all vertices back towards the input, as long as the
/// sum of the squares of their distances from it falls; at last those that meet
/// nothing on the way are sent to where they were, bit for bit.  Nothing but
/// positions changes.
///
/// What is promised: after TF_OK the output is clear, and `left` is empty, or
/// it is the state of fewest intersections that was found, never more than the
/// input has, and `left` lists them.  Fixed vertices stay, bit for bit; where
/// only they intersect nothing is tried.  What is not: that a clear state is
/// found, since some surfaces have none; that the output is the nearest; that
/// it is the one that somebody had in mind, or that it can be reached from the
/// input by a motion, which no motion without contacts can.
///
/// The result is the same, to the last bit, for any number of threads.
///
/// @param resolver a resolver of the surface.  What a filter of the surface
///     leaves out may intersect
/// @param vertices how many vertices have positions
/// @param in where they are, three coordinates each, in the plane two
/// @param[out] out where they end; may be the same array as `in`; set only with
///     TF_OK
/// @param options how; NULL: all zero
/// @param[out] report what was done; set only with TF_OK; may be NULL
/// @param[out] left the intersections of `out`, lent until the next call for
///     the surface; set only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the surface has another number of vertices;
///     TF_NOT_FINITE; TF_BAD_OPTION; TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or
///     TF_CANCELLED, and then `out` is as it was
TF_API tf_status tf_untangle(tf_resolver *resolver, int vertices,
                             const double in[], double out[],
                             const tf_untangle_options *options,
                             tf_untangle_report *report, tf_crossings *left,
                             tf_error *error);

/// @}
