//: Declare what a row sees and does
#pragma once

#include "response/row.h"

/// The vertices that rows push, in the numbering that the rows use.
typedef struct tf_bodies {
    int axes;
    const double *inverse_mass;
    double *displacement; ///< `axes` numbers each
} tf_bodies;

/// Returns how far the displacements part the elements of a row along its
/// normal.
double tf_row_parting(int axes, const tf_row *row, const double displacement[]);

/// Returns how far an impulse of 1 parts the elements of a row: its entry on
/// the diagonal of a zone's matrix.  Zero if all of its vertices are scripted,
/// or if the push would move a vertex more than 1024 times as far as it parts
/// the elements.
double tf_row_compliance(const tf_row *row, const double inverse_mass[]);

/// Applies an impulse to the vertices of a row, in proportion to their
/// coefficients.
void tf_row_push(const tf_row *row, const double impulse[3],
                 const tf_bodies *bodies);

//: Declare the visit of a row
/// Sets the impulse of a row to the least one, 0 or more, with which the
/// present displacements satisfy the row.  Then sets its friction to the
/// impulse across the normal that stops the elements from sliding, or to
/// `friction` times the impulse in that direction if this is less.  Does
/// nothing if all vertices of the row are scripted.  Returns by how much the
/// parting along the normal has changed or, if that is more, the sliding across
/// it.
double tf_row_visit(tf_row *row, double friction, const tf_bodies *bodies);
