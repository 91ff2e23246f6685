// Journeys of tangles: by one rung to a clear state, and from there home.
#ifndef FIG_JOURNEYS_H
#define FIG_JOURNEYS_H

#include "kit/tangles.h"
#include "renderer/page.h"
#include "untangle/options.h"

enum {
    FIG_JOURNEY_STATES = 96
};

/// The states of a journey: the input first, `found` the first clear one, and
/// after it one for each step home, in each of which nothing meets.
typedef struct fig_journey {
    fig_tangle tangle;
    int states, found;
    double *x[FIG_JOURNEY_STATES];
    int rounds[FIG_JOURNEY_STATES];  ///< before each state: of smoothing, then
                                     ///< steps
    double away[FIG_JOURNEY_STATES]; ///< the root mean square of the distances
                                     ///< from the input, in mean edges
    size_t crossings;                ///< of the input
} fig_journey;

/// The journey by TF_RUNG_SMOOTH, of everything, or TF_RUNG_APART; kept as long
/// as the program lives.
const fig_journey *fig_journey_of(const char *name, tf_untangle_rung rung);

/// Draw the state at a time from 0 to 1 in a box, with its curves; states are
/// equally long.  Between the input and what TF_RUNG_APART finds there is
/// nothing: it jumps.
void fig_journey_draw(fig_page *page, fig_box box, const fig_journey *all,
                      double time);

/// Plot how far all states are from home, and where a time is.
void fig_journey_plot(fig_page *page, fig_box box, const fig_journey *all,
                      double time, const char *name_x);

#endif
