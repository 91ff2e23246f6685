//: Declare the rungs of an untangling
#pragma once

#include "base/api.h"
#include "base/progress.h"
#include "surface/parallel.h"

#include <stdbool.h>
#include <stddef.h>

/// @addtogroup untangling Untangling
/// @{

/// What an untangling tries, each where those before it get no further: in this
/// order, but TF_RUNG_APART before TF_RUNG_AGAIN.  A rung is a bit, so that
/// several can be added up.
typedef enum tf_untangle_rung {
    TF_RUNG_PUSH =
        1, ///< push what is on the wrong side of a crossing curve out
           ///< through the surface that it has passed
    TF_RUNG_SMOOTH = 2, ///< smooth what is near the crossings
    TF_RUNG_AGAIN = 4,  ///< begin anew, with more facets to go to
    TF_RUNG_APART = 8,  ///< move whole parts apart: a jump, which is no motion
    TF_RUNG_RELAX = 16, ///< smooth everything
    TF_RUNG_RETURN =
        32 ///< from a clear state back towards the input, as far as
           ///< it is clear: a motion without contacts
} tf_untangle_rung;

//: Declare how to untangle
/// How to untangle.  Zero is the usual choice everywhere.
typedef struct tf_untangle_options {
    size_t size; ///< sizeof(tf_untangle_options); 0: that of the version that
                 ///< introduced it
    const bool *fixed; ///< which vertices stay where they are, one for each
                       ///< vertex; NULL: none
    int rounds;  ///< the most rounds of an attempt, of which there are at most
                 ///< three before everything is smoothed; 0: 300, and as many
                 ///< again whenever an attempt has halved its intersections
    int without; ///< the sum of the rungs that are left out
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    tf_progress *progress;       ///< NULL: nothing is told
    void *context;               ///< passed on to `progress`
} tf_untangle_options;

//: Declare the report of an untangling
/// What an untangling did.  Later versions may add to its end.
typedef struct tf_untangle_report {
    size_t before;   ///< intersections of the input
    size_t left;     ///< those of the output; 0: it is clear
    size_t beyond;   ///< of those of the output, those of fixed vertices alone,
                     ///< which nothing can end
    int parts;       ///< connected parts of the surface
    int rounds;      ///< of all rungs before the return
    int rungs;       ///< the sum of those that moved something
    int moved;       ///< how many vertices are not where they were
    double farthest; ///< the most that one has moved, a length
    double mean;     ///< by how much those that moved have, on average
    double
        deviation;  ///< the root of the mean of the squares, over all vertices
    double found;   ///< that of the clear state, before the return; 0 if no
                    ///< clear state was found
    double edge;    ///< the mean length of the input's edges
    int stretched;  ///< edges whose length has grown or shrunk by more than
                    ///< a factor of 1.5
    double stretch; ///< the largest factor, grown or shrunk, at least 1
    double volume_before; ///< the sum of the volumes that closed parts enclose,
                          ///< each at least 0, whichever of its sides is out;
                          ///< in the plane, areas
    double volume_after;  ///< the same of the output, where those of parts that
                          ///< were turned inside out are negative
    int turned;           ///< closed parts whose volume has changed its sign
} tf_untangle_report;

/// @}
