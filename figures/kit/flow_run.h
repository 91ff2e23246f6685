// Scenes of surfaces that flow, run for figures.
#ifndef FIG_FLOW_RUN_H
#define FIG_FLOW_RUN_H

#include "kit/cloth.h"
#include "remesh/policy.h"
#include "simulate/flow_simulation.h"

/// What is to be run.
typedef struct fig_flow_plan {
    const char *scene;
    double edge;
    int steps, every;               ///< of so many steps one is kept
    const tf_remesh_policy *policy; ///< NULL: that of the library
    bool keep_topology;             ///< also where the scene would not
} fig_flow_plan;

/// A surface as it was after some steps.
typedef struct fig_flow_frame {
    tf_surface *surface;
    double *x;
    tf_flow_measures measures;
} fig_flow_frame;

/// A scene after it was run.
typedef struct fig_flow_run {
    int frames; ///< the first is the start
    fig_flow_frame *frame;
    int first
        [TF_RECONNECTIONS]; ///< the step of the first one; 0: there is none
} fig_flow_run;

/// Runs a scene.  What it returns lives as long as the program, since all pages
/// of a film show the same run.
fig_flow_run *fig_flow_run_new(const fig_flow_plan *plan);

/// All frames of some runs, which fit into one box: those of the first run, then
/// those of the second, and so on.  They live as long as the program.
fig_cloth **fig_flow_run_films(int runs, fig_flow_run *const run[]);

#endif
