//: Declare a round of impulses
#pragma once

#include "response/contact_constraint.h"
#include "response/impulse.h"
#include "surface/contacts.h"

/// Visits the constraint of each contact once, one after another, and then
/// moves the vertices.  `displacement` is room for 2 times `axes` numbers for
/// each vertex of the step; `constraint` and `gap` are room for one for each
/// contact: they are filled in, with their impulses and pushes.
void tf_impulses_round(tf_step *step, const tf_contacts *contacts,
                       const tf_contact_rule *rule, tf_friction friction,
                       double displacement[], tf_constraint constraint[],
                       tf_contact_gap gap[]);
