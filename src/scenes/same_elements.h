//: Declare how to compare elements
#pragma once

#include "formats/mesh_file.h"

/// Whether two files have the same elements in the same order.  False: the first
/// difference is the fault of the file `a`.
bool tf_have_same_elements(const tf_mesh_file *a, const tf_mesh_file *b);
