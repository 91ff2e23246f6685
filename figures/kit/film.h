// What figures that move have in common.
//
// The frames of a film are drawn one by one and must not jump: a moving figure
// fits its cameras to all that it reaches, and sets letters with fig_film_name
// or fig_page_text, since a label looks for another place in every frame.
#ifndef FIG_FILM_H
#define FIG_FILM_H

#include "renderer/figure.h"

enum {
    FIG_FILM_FRAMES = 49
}; ///< of a film in the book: every 48th of the step, and both ends

/// The time that a page shows: that of the frame or, on a page of no film,
/// `still`, which is printed for the book as the number film_still.  The frame
/// nearest to `event` is drawn at that very time; -1 is none.
double fig_film_time(const fig_page *page, FILE *numbers, double still,
                     double event);

/// A line of time from (x, y) on, `width` points long, on which `t` has been
/// reached, and the time in letters.  From `event` on it is marked and named
/// `name`; -1 is none.
void fig_film_clock(fig_page *page, double x, double y, double width, double t,
                    double event, const char *name);

/// A name beside a point of a panel's world, its middle dx points to the right
/// and dy points down from there.  The panel's scene must be complete as far as
/// its camera is fitted to it.
void fig_film_name(fig_page *page, const fig_panel *panel, tf_vector at,
                   double dx, double dy, const char *text, fig_role role);

#endif
