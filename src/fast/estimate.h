//: Declare the estimate of a contact
#pragma once

#include "query/contact.h"
#include "query/motion.h"
#include "query/narrow_phase.h"

#include <stdbool.h>

/// Estimates the contact of a point and a triangle or of two edges, whose vertices
/// are in increasing order, in an IEEE environment.  False, and no contact, if
/// rounded numbers cannot tell for sure that the elements meet, between which of
/// their pieces first, and where and when within about 2^-20.  As in an exact
/// contact, everything depends on the two elements alone, and no time of contact
/// that is not 0 is estimated as 0.
bool tf_contact_estimate(tf_kind kind, const tf_motion *motion,
                         const int vertex[4], tf_contact *contact);
