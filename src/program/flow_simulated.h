//: Declare simulated flows
#pragma once

#include "program/simulated.h"
#include "simulate/flow_measures.h"
#include "simulate/flow_simulation.h"

/// A scene of a surface that flows.
typedef struct tf_flow_simulated {
    tf_simulated base;
    tf_flow_simulation *simulation;
    tf_flow_measures measures;       ///< after the last step
    tf_flow_report last;             ///< what the last step did
    size_t contacts;                 ///< of all steps that were made here
    tf_reconnect_report reconnected; ///< in all of them
    double seconds[TF_FLOW_PARTS];   ///< in all of them
    int steps, failsafes; ///< made here, and of these with the failsafe
} tf_flow_simulated;

/// Sets a scene up.
/// @param edge above 0, and at most scene->most
/// @param[out] simulated to be freed by its kind; set only with TF_OK
/// @return as tf_flow_simulation_create
tf_status tf_flow_simulate(const tf_flow_scene *scene, double edge,
                           tf_simulated **simulated);
