//: Declare the row of a contact
#pragma once

#include "response/row.h"
#include "response/step.h"
#include "surface/detect.h"

/// How contacts become rows.
typedef struct tf_row_rule {
    double separation;  ///< pairs that are nearer at the start are pushed apart
    double restitution; ///< 0 to 1
    const double *base; ///< the ends from which rows are satisfied
} tf_row_rule;

/// The row of a contact in a step, by its vertices in the step.  `by_pivots`:
/// rather the row of the contact's pivots than that of its point.  `*gap` is how
/// far the elements are apart at the start, along the row's normal.
tf_row tf_row_of_contact(const tf_step *step, const tf_surface_contact *contact,
                         const tf_row_rule *rule, bool by_pivots, double *gap);
