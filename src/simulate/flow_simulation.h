//: Declare simulations of flows
#pragma once

#include "flow/flow.h"
#include "simulate/flow_measures.h"
#include "simulate/simulation.h"

/// A surface that flows in a scene, whose setup it does not keep.
typedef struct tf_flow_simulation {
    tf_simulation base;
    tf_adaptive_surface *surface;
    tf_flow *flow;             ///< of the surface
    tf_flow_measures measures; ///< of the surface
    tf_flow_report report;     ///< of the last step, without what it points to
    tf_reconnect_report reconnected; ///< which is here
    tf_response_report response;     ///< and here
} tf_flow_simulation;

/// A surface is remeshed, merges and comes apart, and moves along the field.
extern const tf_simulation_kind tf_flow_kind;

/// How a surface flows in a scene.
tf_flow_options tf_flow_options_of(const tf_scene *scene, double edge);
