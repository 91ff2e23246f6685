// Scenes of the simulator, run for figures.
#ifndef FIG_CLOTH_RUN_H
#define FIG_CLOTH_RUN_H

#include "kit/cloth.h"
#include "simulate/cloth_simulation.h"

/// What is to be run.
typedef struct fig_cloth_plan {
    const char *scene;
    int size, steps;
    bool unresolved; ///< nothing looks after collisions
    int check;   ///< every so many steps intersections are counted; 0: never
    bool chosen; ///< friction and separation are those below
    double friction, separation;
} fig_cloth_plan;

/// What a step took, and what is so after it.
typedef struct fig_cloth_step {
    tf_response_report report;
    int crossings; ///< of an edge and a triangle
    double stretch, kinetic, elastic;
} fig_cloth_step;

/// A scene after it was run.
typedef struct fig_cloth_run {
    tf_cloth_simulation *simulation; ///< after the last step
    int steps, axes, vertices;
    double *x;            ///< positions after 0 and more steps
    fig_cloth_step *step; ///< after 0 and more steps
} fig_cloth_run;

/// Runs a scene, or finds the run of the same plan: runs are kept as long as the
/// program lives, since pages of a film, and those of both themes, share them.
const fig_cloth_run *fig_cloth_run_of(const fig_cloth_plan *plan);

/// Positions after a number of steps.
const double *fig_cloth_run_at(const fig_cloth_run *run, int step);

/// How many steps needed a level.
int fig_cloth_run_count(const fig_cloth_run *run, tf_response_level level);

/// The run's surface in some of its frames, from `first` on, each `every`
/// steps: to be drawn.
fig_cloth *fig_cloth_run_film(const fig_cloth_run *run, int first, int every);

#endif
