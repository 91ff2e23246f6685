//: Declare a round of impulses
#pragma once

#include "response/contact_row.h"
#include "surface/detect.h"

/// Answers each contact by an impulse of its own, one after another.
/// `displacement` has room for `axes` numbers for each vertex of the step.
void tf_impulses_round(tf_step *step, const tf_contacts *contacts,
                       const tf_row_rule *rule, double friction,
                       double displacement[]);
