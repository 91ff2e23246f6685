//: Declare simulations
#pragma once

#include "base/status.h"
#include "response/resolve.h"
#include "simulate/dynamics.h"
#include "simulate/scene.h"

/// A scene in the course of time.  A step does not depend on what came before it
/// except for the positions, the velocities, the number of the step and that of
/// the script.
typedef struct tf_simulation {
    const tf_scene *scene;
    int size;
    tf_stage stage;
    int step;         ///< how many were made
    int scripted;     ///< how many of them have moved all handles: while
                      ///< scripted vertices are held back, the script waits
    double *position; ///< of the vertices
    double *velocity; ///< of the vertices, in meters per second
    double *end;      ///< where they are to be after the step
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
/// What a step took.
typedef struct tf_step_cost {
    tf_response_report report;
    double dynamics, response; ///< seconds
} tf_step_cost;

/// How to make a step.
typedef struct tf_step_way {
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    bool check; ///< whether to look for intersections at the start, too
    double (*clock)(void); ///< seconds; NULL: the cost has no times
} tf_step_way;

/// Makes a step in which nothing meets: the dynamics propose where it ends, and
/// the response has the last word.
///
/// The response does not know of the springs.  It stops a vertex by an impulse
/// for its own mass, and in the next step the springs pull it on.  So where
/// step^2 times stiffness is much more than the mass of a vertex, contacts stop
/// the surface but not what hangs on it, which is stretched.  The materials and
/// steps of the scenes, in their usual sizes, keep that ratio below 100.
/// @param[out] cost set only with TF_OK
/// @return as tf_step_resolve
tf_status tf_simulation_step(tf_simulation *simulation, const tf_step_way *way,
                             tf_step_cost *cost);

//: Declare the parts of a step
/// Sets `end` to where the dynamics lead, through whatever is in the way.
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_simulation_propose(tf_simulation *simulation);

/// Goes on to `end`: the velocities are those that lead there.
/// @param held how many scripted vertices were held back
void tf_simulation_accept(tf_simulation *simulation, int held);
