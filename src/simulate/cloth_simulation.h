//: Declare simulations of cloth
#pragma once

#include "simulate/coupling.h"
#include "simulate/dynamics.h"
#include "simulate/simulation.h"

/// What a step of cloth took, and how the cloth is after it.
typedef struct tf_cloth_report {
    tf_response_report response;
    double dynamics_seconds, response_seconds;
    double stretch;          ///< as tf_body_stretch
    double kinetic, elastic; ///< energies, in joules
} tf_cloth_report;

/// A scene of cloth in the course of time.
typedef struct tf_cloth_simulation {
    tf_simulation base;
    int script_steps; ///< how many steps have moved all scripted vertices: while
                      ///< some are held back, the scripts wait
    double *position; ///< of the vertices
    double *velocity; ///< of the vertices, in meters per second
    double *end;      ///< where they are to be after the step
    double *inverse_mass;
    tf_surface *surface;
    tf_resolver *resolver;
    tf_coupling *coupling;
    tf_dynamics *dynamics;
    tf_cloth_report report; ///< of the last step
} tf_cloth_simulation;

//: Declare a step of cloth
/// A step in which nothing meets: the dynamics propose where it ends, the springs
/// and what is in the way come to terms, and the response has the last word.
extern const tf_simulation_kind tf_cloth_kind;

/// Sets `end` to where the dynamics lead, through whatever is in the way.
/// @return TF_OK, TF_OUT_OF_MEMORY, or TF_CANCELLED if the path of the scene
///     cannot be found
tf_status tf_cloth_propose(tf_cloth_simulation *cloth);

/// The energy at the start of a step, before it is proposed.
tf_coupling_energy tf_cloth_energy(const tf_cloth_simulation *cloth);

/// Moves `end` to where nothing meets and the springs agree.
/// @param energy at the start, which counts where no wind blows
/// @return what tf_coupling_resolve returns
tf_status tf_cloth_resolve(tf_cloth_simulation *cloth,
                           const tf_coupling_energy *energy,
                           const tf_response_options *options,
                           tf_response_report *report);

/// Goes on to `end`.
/// @param unpushed where the motion leads: it decides the velocities
/// @param held how many scripted vertices were held back
void tf_cloth_accept(tf_cloth_simulation *cloth, const double unpushed[],
                     int held);
