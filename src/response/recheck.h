//: Declare how contacts are looked for
#pragma once

#include "response/step.h"
#include "surface/pairs.h"

/// Finds all contacts of a step from the beginning, and keeps all pairs of
/// elements whose boxes overlap.  Which pairs are in contact is exact; what
/// describes a contact is estimated where it can be (tf_contact_estimate).
/// Returns what tf_surface_move does, with the reason in `flaw`, or what the
/// narrow phase does.
tf_status tf_check_all(tf_surface *surface, tf_step *step,
                       const tf_narrow_phase *narrow_phase,
                       const tf_parallel *parallel, tf_contacts *found,
                       tf_flaw *flaw);

/// Finds the contacts among the pairs that tf_check_all has kept.  Looks only at
/// pairs that were in contact and at those that have moved so far that they could
/// be now.  Returns TF_OK, TF_OUT_OF_MEMORY, or what the narrow phase does.
tf_status tf_recheck(tf_surface *surface, tf_step *step,
                     const tf_narrow_phase *narrow_phase,
                     const tf_parallel *parallel, tf_contacts *found);
