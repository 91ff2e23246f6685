//: Declare what a flow reports
#pragma once

#include "base/api.h"
#include "remesh/options.h"
#include "response/options.h"
#include "topology/options.h"

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
    size_t shifted[TF_OUTCOMES];     ///< the same of moves that restore volume
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
    bool keep_topology; ///< whether nothing is to merge, pinch or vanish
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    double (*clock)(void);       ///< seconds; NULL: the report has no times
} tf_flow_options;

/// @}
