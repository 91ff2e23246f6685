//: Declare how an edge flips
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Replaces the edge between two triangles by the other diagonal.
/// @param surface the surface
/// @param a one end of the edge
/// @param b the other end
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_flip(tf_adaptive_surface *surface, int a, int b,
                                  tf_outcome *outcome);

/// @}
