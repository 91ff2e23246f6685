// Films of scenes of surfaces that flow.
#ifndef FIG_FLOW_FILM_H
#define FIG_FLOW_FILM_H

#include "kit/flow_run.h"

#include <stdio.h>

/// A film, which is run when it is first drawn.
typedef struct fig_flow_film {
    fig_flow_plan plan;
    fig_cloth_look look;
    double still; ///< the time that a page of no film shows, 0..1
    fig_flow_run *run;
    fig_cloth **cloth;
} fig_flow_film;

/// Draws the frame of the page's time in a box, and prints edge, steps, merge
/// and pinch, the first steps that merge and pinch, triangles, those in the
/// end, and parts, the components then.
void fig_flow_film_draw(fig_flow_film *film, fig_page *page, fig_box box,
                        FILE *numbers);

#endif
