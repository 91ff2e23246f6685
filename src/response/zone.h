//: Declare zones
#pragma once

#include "base/api.h"
#include "response/constraint.h"

#include <stdbool.h>
#include <stddef.h>

/// @addtogroup response
/// @{

/// An impact zone: constraints that share vertices, to be satisfied together
/// with as little change as possible.  It is a problem on its own, with its own
/// numbering of vertices: find the displacements d that satisfy all constraints
/// with the least sum of mass |d - proposal|^2.
typedef struct tf_zone {
    int axes;        ///< 2 or 3
    int vertices;    ///< how many
    int constraints; ///< how many, at least 1
    int solved;      ///< how many constraints, at the beginning of the list,
                     ///< were solved before; a solver may skip them
    tf_constraint *constraint;  ///< their vertices are numbered from 0 to
                                ///< `vertices` - 1; in: impulses to start from,
                                ///< or 0; out: the impulses that were found
    const double *inverse_mass; ///< of each vertex; 0: it is scripted; each
                                ///< constraint has at least one vertex that is
                                ///< not; if `friction` is negative, these
                                ///< numbers are followed by Coulomb's
                                ///< coefficient of each vertex
    double *displacement;       ///< `axes` numbers for each vertex; in: as
                                ///< proposed; out: with all impulses applied
    double friction;            ///< Coulomb's coefficient; 0: none; negative:
                                ///< tf_zone_friction tells that of a constraint
    int sweeps;                 ///< the most iterations to make, at least 1
    void *watch;                ///< for tf_zone_goes_on; NULL: nobody cancels
    double *workspace;          ///< as many numbers as the solver asks for,
                                ///< in allocated memory, as a solver may keep
                                ///< other types there
} tf_zone;

//: Declare solvers
/// A solver of zones: a constant whose address is passed to the response.
typedef struct tf_zone_solver {
    const char *name; ///< in static storage

    /// Returns how many numbers `solve` needs in the zone's `workspace`.
    size_t (*workspace)(int axes, int vertices, int constraints);

    /// Finds impulses, applies them, and returns how many iterations that took.
    /// It need not satisfy all constraints, but the impulses must depend on
    /// nothing but the zone.  When tf_zone_goes_on says false it may return at
    /// once, and leave anything in the zone.  Thread-safe.
    int (*solve)(tf_zone *zone);
} tf_zone_solver;

//: Declare how a solver is cancelled
/// Whether a solver is to go on.  It is told how much it has done since the last
/// time, and asks as often as it likes, at least once in some milliseconds: for
/// each constraint that it visits, say.  A solver that never asks delays a
/// caller who cancels until it is done with a zone.  Thread-safe.
/// @param zone the zone
/// @param visits how many constraints it has visited since it last asked, or
///     what takes as long
/// @return false: the caller has cancelled the step, and the zone's impulses and
///     displacements are of no use any more; the answer will stay the same
TF_API bool tf_zone_goes_on(const tf_zone *zone, size_t visits);

//: Declare how a solver learns of friction
/// Finds Coulomb's coefficient of a constraint of a zone: that of the zone, or if
/// vertices have their own, the geometric mean of those of the two elements.
/// Thread-safe.
/// @param zone the zone
/// @param constraint one of its constraints, with the zone's numbers of vertices
/// @return 0 or more
TF_API double tf_zone_friction(const tf_zone *zone,
                               const tf_constraint *constraint);

//: Declare the product with a zone's matrix
/// Adds the effect of one impulse for each constraint, along its normal, to the
/// displacements of a zone's vertices.  The constraints' own impulses and
/// friction play no part.  As the next two functions it stops early, and what it
/// has written is of no use, when tf_zone_goes_on says false.  Thread-safe.
/// @param zone the zone
/// @param impulse one number for each constraint
/// @param[in,out] displacement `axes` numbers for each vertex
TF_API void tf_zone_push(const tf_zone *zone, const double impulse[],
                         double displacement[]);

/// Finds by how much displacements widen the gap of each constraint.
/// Thread-safe.
/// @param zone the zone
/// @param displacement `axes` numbers for each vertex
/// @param[out] gap_change the left side of the inequality of each constraint
TF_API void tf_zone_gap_changes(const tf_zone *zone,
                                const double displacement[],
                                double gap_change[]);

/// Multiplies a zone's matrix by a vector of impulses: finds by how much they
/// widen the gap of each constraint if all vertices are at rest.  Thread-safe.
/// @param zone the zone
/// @param impulse one number for each constraint
/// @param[out] gap_change one number for each constraint
/// @param workspace `axes` numbers for each vertex, overwritten
TF_API void tf_zone_multiply(const tf_zone *zone, const double impulse[],
                             double gap_change[], double workspace[]);

/// @}
