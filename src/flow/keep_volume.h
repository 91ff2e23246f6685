//: Declare the policy that keeps the volume
#pragma once

#include "remesh/policy.h"

/// Keeps the volume that a surface encloses, up to rounding, by each operation
/// itself; it needs no original.
extern const tf_remesh_policy tf_keep_volume;
