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

/// What it took to resolve a step, in all of its substeps.  Where scripted
/// vertices are held back, all but the statistics is about the last trial,
/// which is the step that is returned.  Lent; later versions may add to its
/// end.
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
    int held;            ///< scripted vertices that do not go all of their way
    int moved;           ///< vertices whose end is not the proposed one
    tf_detect_statistics statistics; ///< that of all detections
    double energy_before; ///< the kinetic energy of the proposed step, the sum
                          ///< of mass |d|^2 / 2, with displacements d, over
                          ///< all vertices that are not scripted
    double energy_after;  ///< that of the resolved step, without what pushes
                          ///< pairs apart: that of tf_resolver_unpushed
    double followed;      ///< the least fraction of its script that a scripted
        ///< vertex followed, see tf_resolver_followed; 1: none was
        ///< held back
    size_t first_near; ///< pairs that the proposed step brings nearer than the
                       ///< thickness, if it has no contacts
    size_t near;       ///< those of all rounds without contacts
    size_t near_at_start; ///< pairs that are nearer than that at the start, to
                          ///< which it doesn't apply
} tf_response_report;

//: Declare answered contacts
/// A contact of a step that was resolved, and how a level of the response
/// answered it.  Impulses and zones add
///
///     inverse_mass_i coefficient[i] (impulse normal + friction)
///
/// to the displacement of vertex[i].  Where only they have moved a vertex,
/// the sum of all these is, up to rounding, the difference between where it
/// ends without pushes, as tf_resolver_unpushed says, and where it was
/// proposed to end; with the pushes of tf_resolver_pushes it is that
/// between where it ends and where it was proposed to end.  Rigid zones and
/// the failsafe have no impulses.  In substeps, impulses are about the
/// displacement in one of them; so only the second sum is of use, and only
/// without restitution.  A pair that comes nearer than the thickness, in a
/// round that has no contacts, is listed like one, with a toi of 1.  Its
/// layout is final.
typedef struct tf_answered_contact {
    tf_kind kind;            ///< of what elements
    int vertex[4];           ///< theirs, in the order of a tf_surface_contact
    tf_response_level level; ///< which level answered
    int round;               ///< in which of its rounds in the substep, from 0
    int reserved;            ///< 0
    double toi; ///< when they met, 0 to 1, in the step as it was before
                ///< this round
    double coefficient[4]; ///< how much of them goes to each vertex: those of
                           ///< the first element add up to +1, the others to -1
    double normal[3];   ///< of length 1, from the second element to the first;
                        ///< or zero, if nothing pushed and there was none
    double impulse;     ///< in units of mass times length; at least 0, but for
                        ///< solvers that also pull
    double friction[3]; ///< an impulse across the normal
} tf_answered_contact;

//: Declare what happened to vertices
/// What the response did with a vertex; flags to be added up.  Later
/// versions may add to this list.
typedef enum tf_vertex_flag {
    TF_VERTEX_MOVED = 1,   ///< it does not end where it was proposed to end
    TF_VERTEX_HELD = 2,    ///< scripted, and does not go all of its way
    TF_VERTEX_GROUPED = 4, ///< in a group of the failsafe with other vertices
    TF_VERTEX_RESTING = 8, ///< in a group that stays at its start
    TF_VERTEX_RIGID = 16   ///< moved with a rigid zone
} tf_vertex_flag;

//: Declare how to respond
/// How to respond.  Zero is the usual choice everywhere, and a negative number
/// means none, where it says so.
typedef struct tf_response_options {
    size_t size; ///< sizeof(tf_response_options); 0: that of version 1.0
    const tf_zone_solver *solver; ///< of the motion; NULL: tf_gauss_seidel
    int impulse_rounds; ///< rounds of impulses, before zones; 0: the usual
                        ///< number, which is none; negative: none
    int zone_rounds;    ///< the most rounds of zones; 0: 20; negative: none
    int sweeps;         ///< iterations of the solver, 1 or more; 0: 30
    bool rigid;         ///< whether to try rigid zones before the failsafe
    double separation;  ///< pairs in contact that start nearer than this, and
                        ///< nearer than half of the way by which they were to
                        ///< approach each other, are pushed apart, a part of
                        ///< the way; 0: 0.05 of the mean edge at the start;
                        ///< negative: none are
    double restitution; ///< the part of their normal velocity with which
                        ///< elements move apart after a collision, from 0,
                        ///< which is usual, to 1
    double friction;    ///< Coulomb's coefficient, 0, which is usual, or more
    bool check_start;   ///< whether to look for intersections at the start, too
    const tf_narrow_phase *narrow_phase; ///< NULL: tf_vectorized
    const tf_parallel *parallel;         ///< NULL: the caller's thread alone
    tf_progress *progress;               ///< NULL: nothing is told
    void *context;                       ///< passed on to `progress`

    /// Elements that were to approach each other by less than this length in the
    /// step have no restitution, so that what bounces comes to rest; 0, which is
    /// usual: all have.  With a gravity g and a step of dt seconds,
    /// 2 g dt^2 / (1 - restitution) is enough.
    double restitution_threshold;

    /// Coulomb's coefficient of each vertex, finite, 0 or more, in place of
    /// `friction`; NULL: that is the one of all vertices.  Where an element is
    /// touched, it has the mean of the coefficients of its vertices, weighted by
    /// barycentric coordinates, and a pair has the geometric mean of those of
    /// its two elements, which is 0 if one of them is 0.
    const double *vertex_friction;

    int substeps; ///< in how many parts the step is taken, one after another,
                  ///< each clear; see tf_step_resolve; 0, which is usual: 1
    double thickness; ///< pairs that start at this distance or more end at this
                      ///< distance or more; 0, which is usual: they only don't
                      ///< meet.  Those that start nearer, as neighbors in a
                      ///< fine mesh do, only don't meet, either

    int draft; ///< not 0: the step is only drafted, see tf_step_resolve: its end
               ///< need not be clear; not with substeps
    int again; ///< not 0: the last call for the resolver may have answered a step
        ///< from the same start, with one of these two options, and if so,
        ///< this one begins with the pairs that it looked at

    /// Of each triangle, in the plane of each edge, its zone: pairs within one
    /// are left out, see tf_detect_options, and may be tangled at the start.
    /// NULL: no pair is left out.
    const int *zone;
} tf_response_options;

/// @}
