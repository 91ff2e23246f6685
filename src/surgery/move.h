//: Declare how a vertex moves
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Moves a vertex in a straight line.
/// @param surface the surface
/// @param vertex its number
/// @param position where it ends, three coordinates
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_move(tf_adaptive_surface *surface, int vertex,
                                  const double position[3],
                                  tf_outcome *outcome);

/// @}
