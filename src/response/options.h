//: Declare the report of a response
#pragma once

#include "base/api.h"
#include "query/narrow_phase.h"
#include "response/zone.h"
#include "surface/check.h"
#include "surface/contacts.h"
#include "surface/parallel.h"

#include <stdbool.h>
#include <stddef.h>

/// @addtogroup response
/// @{

/// The levels of a response.  Each answers the contacts that those before it
/// leave.
typedef enum tf_response_level {
    TF_IMPULSES = 0, ///< an impulse for each contact by itself
    TF_ZONES,        ///< impact zones
    TF_RIGID,        ///< zones that move as rigid bodies
    TF_FAILSAFE,     ///< groups that move in parallel, or rest
    TF_LEVELS = 8    ///< room for those of later versions
} tf_response_level;

/// What it took to resolve a step.  Lent; later versions may add to its end.
typedef struct tf_response_report {
    size_t first_contacts; ///< contacts of the proposed step
    size_t contacts;       ///< those of all rounds, the first ones included
    int rounds[TF_LEVELS]; ///< how often each level answered
    size_t constraints;    ///< inequalities that were kept
    size_t zones;          ///< how many zones were solved
    size_t largest_zone;   ///< constraints of the largest
    size_t iterations;     ///< those of the solver, in all zones
    double violation; ///< the most by which a solver left a constraint short of
                      ///< its bound, a length
    double smallest_gap; ///< the least distance, along a contact's normal, at
                         ///< the start; 0 if there was no contact
    int groups;          ///< groups of the failsafe, of more than one vertex
    int grouped;         ///< vertices in them
    int resting;         ///< of these, vertices that stay at their start
    int held;            ///< scripted vertices that were held back
    int moved;           ///< vertices whose end is not the proposed one
    tf_detect_statistics statistics; ///< that of all detections
    double energy_before; ///< the kinetic energy of the proposed step, the sum
                          ///< of mass |d|^2 / 2, with displacements d, over
                          ///< all vertices that are not scripted
    double energy_after;  ///< that of the resolved step
} tf_response_report;

//: Declare how to respond
/// How to respond.  Zero is the usual choice everywhere, a negative number none.
typedef struct tf_response_options {
    size_t size; ///< sizeof(tf_response_options); 0: that of version 1.0
    const tf_zone_solver *solver; ///< NULL: tf_gauss_seidel
    int impulse_rounds; ///< rounds of impulses, before zones; 0: the usual
                        ///< number, which is none
    int zone_rounds;    ///< rounds of zones; 0: 20; negative: none
    int sweeps;         ///< iterations of the solver; 0: 30
    bool rigid;         ///< whether to try rigid zones before the failsafe
    double separation;  ///< pairs in contact that start nearer than this are
                        ///< pushed apart, a part of the way; 0: 0.05 of the
                        ///< mean edge at the start; negative: none are
    double restitution; ///< 0 to 1: the part of their normal velocity with
                        ///< which elements move apart after a collision
    double friction;    ///< Coulomb's coefficient, 0 or more
    bool check_start;   ///< whether to look for intersections at the start, too
    const tf_narrow_phase *narrow_phase; ///< NULL: tf_vectorized
    const tf_parallel *parallel;         ///< NULL: the caller's thread alone
    tf_progress *progress;               ///< NULL: nothing is told
    void *context;                       ///< passed on to `progress`
} tf_response_options;

/// @}
