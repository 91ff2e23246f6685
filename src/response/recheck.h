//: Declare how contacts are looked for again
#pragma once

#include "response/step.h"
#include "surface/pairs.h"

/// Finds all contacts of a step, and unmarks all vertices.  Requires that the
/// trees of the surface are those of this step, except that vertices that are
/// marked as changed may have other ends by now; that each contact of the last
/// time has a marked vertex; and that no unmarked vertex has moved since.  `of`
/// says how to decide.  Returns TF_OK or TF_OUT_OF_MEMORY.
tf_status tf_recheck(tf_surface *surface, tf_step *step, tf_deciding *of,
                     const tf_parallel *parallel, tf_contacts *found);
