//: Declare simulated cloth
#pragma once

#include "program/simulated.h"

/// A scene of cloth.
typedef struct tf_cloth_simulated {
    tf_simulated base;
    tf_simulation *simulation;
    tf_step_cost last;    ///< what the last step took
    tf_step_cost total;   ///< what all steps took that were made here
    int steps, failsafes; ///< made here, and of these with the failsafe
} tf_cloth_simulated;

/// Sets a scene up.
/// @param size at least scene->least
/// @param[out] simulated to be freed by its kind; set only with TF_OK
/// @return as tf_simulation_create
tf_status tf_cloth_simulate(const tf_scene *scene, int size,
                            tf_simulated **simulated);
