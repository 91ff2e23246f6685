//: Declare how contacts are looked for again
#pragma once

#include "response/step.h"
#include "surface/pairs.h"

/// Finds all contacts of a step, and unmarks all vertices.  Requires that the
/// surface has the trees of this step, with other ends of the marked vertices at
/// most; that each contact of the last time has a vertex that is marked as
/// changed, and that no unmarked vertex has moved since.  `of` says how to
/// decide.  Returns TF_OK or TF_OUT_OF_MEMORY.
tf_status tf_recheck(tf_surface *surface, tf_step *step, tf_deciding *of,
                     const tf_parallel *parallel, tf_contacts *found);
