//: Declare how to read OBJ
#pragma once

#include "formats/mesh_file.h"

/// Reads Wavefront OBJ: `v` with two or more coordinates, of which the first
/// three count, `f` with three corners or more and `l` with two or more, in all
/// forms of indices; other lines are skipped.  The text of that size ends with a
/// zero.
bool tf_obj_parse(tf_mesh_file *file, const char *text, size_t size);
