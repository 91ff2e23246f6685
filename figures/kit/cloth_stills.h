// Pictures of scenes, side by side.
#ifndef FIG_CLOTH_STILLS_H
#define FIG_CLOTH_STILLS_H

#include "kit/cloth_run.h"

#include <stdio.h>

/// One of the pictures: a scene after its last step.
typedef struct fig_cloth_still {
    fig_cloth_plan plan;
    fig_cloth_look look;
    int first; ///< the camera takes in all steps from this one on
} fig_cloth_still;

/// Runs scenes and draws them from left to right, each with its name, and
/// prints steps and triangles of each: step_sphere, triangles_sphere.
void fig_draw_stills(fig_page *page, FILE *numbers, int count,
                     const fig_cloth_still still[]);

#endif
