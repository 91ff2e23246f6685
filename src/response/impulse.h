//: Declare what a row sees and does
#pragma once

#include "response/row.h"

/// The vertices that rows are about, by the rows' numbers for them.
typedef struct tf_bodies {
    int axes;
    const double *inverse_mass;
    double *displacement; ///< `axes` numbers each
} tf_bodies;

/// How far the displacements part the elements of a row along its normal.
double tf_row_parting(int axes, const tf_row *row, const double displacement[]);

/// How far an impulse of 1 parts them: the row's entry on the diagonal of a
/// zone's matrix.  Zero if none of its vertices can be moved.
double tf_row_compliance(const tf_row *row, const double inverse_mass[]);

/// Applies an impulse to the vertices of a row.
void tf_row_push(const tf_row *row, const double impulse[3],
                 const tf_bodies *bodies);

//: Declare the visit of a row
/// Sets the impulse of a row to the least one, 0 or more, that satisfies it as
/// things are, and its friction to what then stops the elements from sliding,
/// at most `friction` times the impulse.  Returns by how much this changes the
/// parting of the elements along the normal or, if that is more, across it.
double tf_row_visit(tf_row *row, double friction, const tf_bodies *bodies);
