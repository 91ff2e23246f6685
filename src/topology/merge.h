//: Declare how two edges merge
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Joins two edges by a tube.  The two triangles on each of them are removed,
/// and eight new ones lead around from the one hole to the other.
///
/// A merge, a pinch or a drop is all or nothing, too, and what is left is
/// embedded.  But none of them is only a motion of the surface: besides, what is
/// in a ball (here that between the four triangles and the tube), or inside of a
/// component that is dropped, changes sides.  Nothing else does, and no part of
/// the surface is in there.  This is exact; what might be otherwise is refused.
///
/// @param surface the surface
/// @param first the ends of an edge that has two triangles
/// @param second the ends of another one, far enough along the surface that the
///     four triangles have eight vertices, and no edge leads from two of them
///     to the two others
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_merge(tf_adaptive_surface *surface,
                                   const int first[2], const int second[2],
                                   tf_outcome *outcome);

/// @}
