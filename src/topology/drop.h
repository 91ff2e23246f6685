//: Declare how a component is dropped
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Removes the component of a surface that a vertex belongs to, unless it has a
/// boundary or a vertex that is left alone (TF_IMPOSSIBLE), or another component
/// is inside of it (TF_PASSED_VERTEX).
/// @param surface the surface
/// @param vertex the number of a vertex of that component
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_drop(tf_adaptive_surface *surface, int vertex,
                                  tf_outcome *outcome);

/// @}
