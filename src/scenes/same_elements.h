//: Declare how to compare elements
#pragma once

#include "formats/mesh_file.h"

/// Whether a file has the same elements in the same order as the one before it
/// in a sequence; then it gets the triangles that polygons have in that.  False:
/// the first difference is the fault of the file.
bool tf_continue_sequence(tf_mesh_file *file, const tf_mesh_file *before);
