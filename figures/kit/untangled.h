// Tangles, untangled by the library.
#ifndef FIG_UNTANGLED_H
#define FIG_UNTANGLED_H

#include "kit/tangles.h"
#include "untangle/untangle.h"

/// What has become of a tangle.
typedef struct fig_untangled {
    double *x; ///< where the vertices ended
    tf_untangle_report report;
} fig_untangled;

/// Untangles in so many rounds at the most, 0: as many as usual, without some
/// rungs.
fig_untangled fig_untangle(const fig_tangle *tangle, int rounds, int without);
void fig_untangled_free(fig_untangled *untangled);

enum {
    FIG_UNTANGLING_STATES = 64
};

/// The states of an untangling: those after 0, 1 and more rounds, each the best
/// one so far, up to the clear one; and, if there is one, that after the return.
typedef struct fig_untangling {
    fig_tangle tangle;
    int states;
    fig_untangled state[FIG_UNTANGLING_STATES];
    int rounds[FIG_UNTANGLING_STATES]; ///< before each state
} fig_untangling;

/// Untangle the one of that name, or find it: they are kept as long as the
/// program lives.
const fig_untangling *fig_untangling_of(const char *name);

#endif
