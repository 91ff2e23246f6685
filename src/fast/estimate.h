//: Declare the estimate of a contact
#pragma once

#include "query/contact.h"
#include "query/motion.h"
#include "query/narrow_phase.h"

#include <stdbool.h>

/// Estimates the contact of a point and a triangle or of two edges, whose
/// vertices are in increasing order, in an IEEE environment.  Time and place are
/// right to about 2^-20; where pairs of pieces meet at times as near as that, it
/// may describe any of them.  False, and no contact, if rounded numbers cannot
/// tell for sure, and as accurately, which pairs of pieces meet.  No contact is
/// estimated to be at the start.
bool tf_contact_estimate(tf_kind kind, const tf_motion *motion,
                         const int vertex[4], tf_contact *contact);
