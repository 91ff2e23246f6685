//: Declare what a constraint sees and does
#pragma once

#include "geometry/vector.h"
#include "response/constraint.h"

/// The vertices that constraints push, in the numbering that the constraints
/// use.
typedef struct tf_bodies {
    int axes;
    const double *inverse_mass;
    double *displacement; ///< `axes` numbers each
} tf_bodies;

/// Returns the gap change: by how much the displacements widen the gap between
/// the elements of a constraint along its normal.
double tf_constraint_gap_change(int axes, const tf_constraint *constraint,
                                const double displacement[]);

/// Returns by how much an impulse of 1 widens the gap of a constraint: its
/// entry on the diagonal of a zone's matrix.  Zero if all of its vertices are
/// scripted, or if the push would move a vertex more than 1024 times as far as
/// it widens the gap.
double tf_constraint_compliance(const tf_constraint *constraint,
                                const double inverse_mass[]);

//: Declare friction
/// Coulomb's coefficients.
typedef struct tf_friction {
    double all;        ///< that of all vertices
    const double *own; ///< that of each vertex, 0 or more; or NULL
} tf_friction;

/// Returns Coulomb's coefficient of a constraint: the geometric mean of those of
/// its two elements, each of which is the mean of those of its vertices, weighted
/// by the constraint's coefficients.  If all vertices have the same one, it is
/// that, bit for bit.
double tf_constraint_friction(const tf_constraint *constraint,
                              tf_friction friction);

//: Declare the push of a constraint
/// Applies an impulse to the vertices of a constraint, in proportion to their
/// coefficients.
void tf_constraint_push(const tf_constraint *constraint, tf_vector impulse,
                        const tf_bodies *bodies);

//: Declare the visit of a constraint
/// Sets the impulse of a constraint to the least one, 0 or more, with which the
/// present displacements satisfy the constraint.  Then sets its friction to the
/// impulse across the normal that stops the elements from sliding, or to
/// `friction` times the impulse in that direction if this is less.  Does
/// nothing if all vertices of the constraint are scripted.  Returns by how much
/// this widens or narrows the gap or, if that is more, changes the sliding
/// across the normal.
double tf_constraint_visit(tf_constraint *constraint, double friction,
                           const tf_bodies *bodies);
