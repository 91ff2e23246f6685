//: Declare how to describe an obstacle
#pragma once

#include "files/mesh_file.h"
#include "response/options.h"

/// Describes which elements keep a response from its start, as a fault of the
/// file that holds the start; false.
bool tf_obstacle_fault(tf_mesh_file *start, const tf_obstacle *obstacle);

/// Describes which elements intersect, as a fault of their file; false.
bool tf_crossing_fault(tf_mesh_file *file, const tf_crossing *crossing);
