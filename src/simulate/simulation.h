//: Declare simulations
#pragma once

#include "base/status.h"
#include "response/resolve.h"
#include "simulate/dynamics.h"
#include "simulate/scene.h"

/// A scene in the course of time.  A step is these calls: propose and resolve;
/// if something was in the way, follow and resolve again; and accept.  It does
/// not depend on what came before it except for the positions, the velocities,
/// the number of the step and the time of the script.
typedef struct tf_simulation {
    const tf_scene *scene;
    int size;
    tf_stage stage;
    int step;           ///< how many were made
    int scripted;       ///< how many of them have moved all handles: while
                        ///< scripted vertices are held back, the script waits
    double *position;   ///< of the vertices
    double *velocity;   ///< of the vertices, in meters per second
    double *end;        ///< where they are to be after the step
    double *proposed;   ///< what `end` was before the response
    bool *moved;        ///< whether the response moved the vertex
    double *inverse_mass;
    tf_surface *surface;
    tf_resolver *resolver;
    tf_dynamics *dynamics;
} tf_simulation;

/// Sets a scene up.
/// @param size at least scene->least
/// @param[out] simulation to be freed by tf_simulation_free; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_simulation_create(const tf_scene *scene, int size,
                               tf_simulation **simulation);
void tf_simulation_free(tf_simulation *simulation);

//: Declare a step of a simulation
/// Sets `end` to where the dynamics lead, through whatever is in the way.
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_simulation_propose(tf_simulation *simulation);

/// Changes `end` such that nothing meets.
/// @param check whether to look for intersections at the start, too
/// @return as tf_step_resolve
tf_status tf_simulation_resolve(tf_simulation *simulation, bool check,
                                const tf_parallel *parallel,
                                tf_response_report *report,
                                tf_obstacle *obstacle);

/// Sets `end` to where the dynamics lead if the vertices that the response has
/// moved stay, but for those that are scripted.
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_simulation_follow(tf_simulation *simulation);

/// Goes on to `end`: the velocities are those that lead there.
/// @param held how many scripted vertices were held back
void tf_simulation_accept(tf_simulation *simulation, int held);
