//: Declare simulations of flows
#pragma once

#include "flow/flow.h"
#include "simulate/flow_scene.h"
#include "simulate/simulation.h"

/// A surface that flows in a scene.  A step depends on the surface and the number
/// of the step only.
typedef struct tf_flow_simulation {
    const tf_flow_scene *scene;
    double edge;
    int step; ///< how many were made
    tf_adaptive_surface *surface;
    tf_flow *flow; ///< of the surface
} tf_flow_simulation;

/// Sets a scene up.
/// @param edge above 0, and at most scene->most
/// @param[out] simulation to be freed by tf_flow_simulation_free; set only with
///     TF_OK
/// @return as tf_adaptive_create
tf_status tf_flow_simulation_create(const tf_flow_scene *scene, double edge,
                                    tf_flow_simulation **simulation);
void tf_flow_simulation_free(tf_flow_simulation *simulation);

//: Declare how a flow goes on
/// Makes a step.
/// @param[out] report set only with TF_OK
/// @return as tf_flow_step
tf_status tf_flow_simulation_step(tf_flow_simulation *simulation,
                                  const tf_step_way *way,
                                  tf_flow_report *report);

/// Goes on from another surface, after so many steps.
/// @return as tf_adaptive_create; after that nothing is changed
tf_status tf_flow_simulation_restore(tf_flow_simulation *simulation, int step,
                                     const tf_mesh *mesh,
                                     const double position[]);
