//: Declare what a flow reports
#pragma once

#include "base/api.h"
#include "base/progress.h"
#include "remesh/options.h"
#include "response/options.h"
#include "topology/options.h"

/// @addtogroup adaptive
/// @{

/// The parts of a step of a flow.
typedef enum tf_flow_part {
    TF_IMPROVE = 0,   ///< better triangles
    TF_RECONNECT,     ///< merge, pinch and drop
    TF_ADVANCE,       ///< along the velocity
    TF_FLOW_PARTS = 8 ///< room for those of later versions
} tf_flow_part;

/// What a step of a flow has done.  Lent; later versions may add to its end.
typedef struct tf_flow_report {
    /// How often an operation was tried, by its outcome; those that would make
    /// poor triangles are not even tried.
    size_t tried[TF_OPERATIONS][TF_OUTCOMES];
    size_t shifted[TF_OUTCOMES]; ///< the same of moves that restore volume
    const tf_reconnect_report
        *reconnected; ///< how parts have merged and come apart
    const tf_response_report
        *response; ///< of the step of all vertices; all zero if none are left
    double seconds[TF_FLOW_PARTS]; ///< 0 without a clock
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
    size_t size; ///< sizeof(tf_flow_options); 0: that of version 1.0
    double edge; ///< the length that edges should have, above 0; all sizes are
                 ///< fractions of it
    tf_flow_velocity *velocity;  ///< where the surface goes; must not be NULL
    bool keep_topology;          ///< whether nothing is to merge, pinch or
                                 ///< vanish
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    double (*clock)(void *context); ///< seconds; NULL: the report has no times
    tf_progress *progress;          ///< NULL: nothing is told
    void *context; ///< passed on to `velocity`, `clock` and `progress`
} tf_flow_options;

/// @}
