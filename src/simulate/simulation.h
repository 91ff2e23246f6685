//: Declare simulations
#pragma once

#include "base/status.h"
#include "simulate/scene.h"
#include "surface/parallel.h"

/// A scene in the course of time: the first member of what its kind has.
typedef struct tf_simulation {
    const tf_scene *scene;
    double resolution;
    tf_scene_setup
        setup;   ///< the scene's, or empty if its kind needs it no more
    int step;    ///< how many were made
    double time; ///< after those, in seconds
} tf_simulation;

/// Sets a scene up.
/// @param resolution from the least to the most of the scene
/// @param[out] simulation to be freed by tf_simulation_free; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_simulation_create(const tf_scene *scene, double resolution,
                               tf_simulation **simulation);

/// Goes on, or back, to the time after a number of steps.
void tf_simulation_go_to(tf_simulation *simulation, int step);

/// Frees a simulation; NULL is none.
void tf_simulation_free(tf_simulation *simulation);

//: Declare how a simulation goes on
/// How to make a step.
typedef struct tf_step_options {
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    bool check; ///< whether to look for intersections at the start, too
    double (*clock)(void); ///< seconds; NULL: nothing has times
} tf_step_options;

/// The state of a simulation, on which alone its next steps depend.
typedef struct tf_snapshot {
    int step;               ///< how many were made
    int script_steps;       ///< of cloth, how many of them its scripts took
    tf_mesh mesh;           ///< the elements
    const double *position; ///< of each vertex
    const double *velocity; ///< of each vertex of cloth; a flow has NULL
} tf_snapshot;

//: Declare kinds of simulations
/// How the steps of a scene are made: cloth, or a surface that flows.  A
/// constant that scenes refer to.
typedef struct tf_simulation_kind {
    const char *option; ///< what users call the resolution
    size_t size;        ///< of its simulations, in bytes

    /// Takes over what is in the setup.  After a failure it is ended, too.
    tf_status (*begin)(tf_simulation *simulation);
    void (*end)(tf_simulation *simulation);

    /// Makes a step; unless that is TF_OK, it is none.
    tf_status (*step)(tf_simulation *simulation,
                      const tf_step_options *options);

    /// Lends the state, until the next step.
    tf_snapshot (*snapshot)(const tf_simulation *simulation);

    /// Goes on from a state of the same scene in the same resolution; unless
    /// that is TF_OK, nothing is changed.
    tf_status (*restore)(tf_simulation *simulation,
                         const tf_snapshot *snapshot);
} tf_simulation_kind;
