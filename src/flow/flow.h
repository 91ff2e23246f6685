//: Declare what a flow reports
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "remesh/remesh.h"
#include "response/options.h"
#include "surgery/adaptive.h"
#include "topology/reconnect.h"

/// @addtogroup adaptive
/// @{

/// The parts of a step of a flow.
typedef enum tf_flow_part {
    TF_IMPROVE = 0, ///< better triangles
    TF_RECONNECT,   ///< merge, pinch and drop
    TF_ADVANCE,     ///< along the velocity
    TF_FLOW_PARTS   ///< how many parts there are
} tf_flow_part;

/// What a step of a flow has done.
typedef struct tf_flow_report {
    /// How often an operation was tried, by its outcome; those that would make
    /// poor triangles are not even tried.
    size_t tried[TF_OPERATIONS][TF_OUTCOMES];
    size_t shifted[TF_OUTCOMES]; ///< the same of moves that give volume back
    tf_reconnect_report reconnected; ///< how parts have merged and come apart
    tf_response_report response;     ///< of the step of all vertices
    double seconds[TF_FLOW_PARTS];   ///< 0 without a clock
} tf_flow_report;

//: Declare how a surface flows
/// The velocities at some points of a surface.
/// @param context that of the options
/// @param time when
/// @param points how many
/// @param point three coordinates each
/// @param normal a unit vector each, to the front of the surface
/// @param[out] velocity three coordinates each
typedef void tf_flow_velocity(void *context, double time, int points,
                              const double point[], const double normal[],
                              double velocity[]);

/// How a surface flows.
typedef struct tf_flow_options {
    double edge; ///< the length that edges should have, above 0; all sizes are
                 ///< fractions of it
    tf_flow_velocity *velocity; ///< where the surface goes; must not be NULL
    void *context;              ///< passed on to `velocity`
    unsigned careless; ///< operations that need not keep the volume, a bit 1 <<
                       ///< tf_operation each, or 1 << TF_OPERATIONS for the
                       ///< advance: to measure what keeping it is worth
    bool keep_topology; ///< whether nothing is to merge, pinch or vanish
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    double (*clock)(void);       ///< seconds; NULL: the report has no times
} tf_flow_options;

//: Declare a step of a flow
/// Makes a step in which a surface flows: first it gets triangles with edges of
/// about one length, then it is merged and pinched where it is thin, or near to
/// itself, and then all its vertices move along the velocity.
///
/// Long edges are split, others flipped, short ones collapsed and vertices
/// smoothed, each exactly, and such that the volume is kept, up to rounding,
/// unless a move that is to give it back is refused; at a boundary there is no
/// volume to be kept.
/// Merging, pinching and dropping change it; see tf_adaptive_reconnect.  In the
/// end nothing may be left of a surface.
///
/// The vertices then move from where they are to where the method of Runge and
/// Kutta leads, as far as tf_step_resolve lets them.  So the surface stays
/// embedded, and no part of it passes through another.
///
/// A triangle whose edges are all on the boundary stays where it is.  The
/// vertices and triangles get new numbers.
///
/// @param surface the surface
/// @param options how
/// @param time when the step begins
/// @param step how long it takes; below 0: back in time
/// @param[out] report what was done; may be NULL
/// @return TF_OK; TF_BAD_TOLERANCE if the length is not above 0 and finite;
///     TF_NOT_FINITE if a velocity leads out of what doubles can hold;
///     TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY; unless it is TF_OK the surface
///     is still embedded, but may have other triangles than before
TF_API tf_status tf_adaptive_flow(tf_adaptive_surface *surface,
                                  const tf_flow_options *options, double time,
                                  double step, tf_flow_report *report);

/// @}
