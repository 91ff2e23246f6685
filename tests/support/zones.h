// Impact zones to try: random ones, and what solves their equations.
#ifndef SUPPORT_ZONES_H
#define SUPPORT_ZONES_H

#include "response/zone.h"
#include "support/generator.h"

#include <stdbool.h>

/// A zone with arrays of its own.
typedef struct zone_case {
    tf_zone zone;
    int most_constraints;
    double *proposal;          ///< the displacement, before any solver
    double *displacement;      ///< the zone's
    double *inverse_mass;      ///< the zone's
    tf_constraint *constraint; ///< the zone's
} zone_case;

/// Room for a zone.
zone_case zone_new(int axes, int vertices, int most_constraints);
void zone_free(zone_case *z);

/// A zone of generic constraints, some of its vertices scripted.
zone_case zone_random(generator *random, int axes, int vertices,
                      int constraints, int most_constraints);

/// Appends a copy of a constraint, whose bound is `part` as much.
void zone_duplicate(zone_case *z, int constraint, double part);

/// Solves it from the proposal and impulses of zero, in at most so many
/// iterations; returns how many.
int zone_solve(zone_case *z, const tf_zone_solver *solver, int sweeps);

/// The same, but starts from the impulses that the constraints have.
int zone_solve_again(zone_case *z, const tf_zone_solver *solver, int sweeps);

/// The least change of the proposal, masses taken into account, that satisfies
/// all constraints as equations, where a constraint that depends on those
/// before it is left out: by orthogonalization in long doubles.
void zone_least_change(const zone_case *z, double displacement[]);

/// The largest difference of two displacements.
double zone_distance(const zone_case *z, const double a[], const double b[]);

/// The length of the residuals of the constraints, taken for equations and
/// scaled by the compliances, as part of what it was for the proposal.
double zone_residual(const zone_case *z);

/// The largest violation of a constraint taken for an inequality, as part of
/// what it was for the proposal.
double zone_violation(const zone_case *z);

#endif
