//: Declare the policy that keeps the shape
#pragma once

#include "remesh/policy.h"

/// Keeps the vertices on the original, and the sharp edges and the boundary as
/// they are.  The remesher needs the original.
extern const tf_remesh_policy tf_keep_shape;
