//: Declare a round of impulses
#pragma once

#include "response/contact_constraint.h"
#include "surface/contacts.h"

/// Visits the constraint of each contact once, one after another, and then
/// moves the vertices.  `displacement` is room for `axes` numbers for each
/// vertex of the step, and `constraint` for one for each contact: they are
/// filled in, with their impulses.
void tf_impulses_round(tf_step *step, const tf_contacts *contacts,
                       const tf_contact_rule *rule, double friction,
                       double displacement[], tf_constraint constraint[]);
