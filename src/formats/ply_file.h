//: Declare how to read PLY
#pragma once

#include "formats/mesh_file.h"

/// Whether a file begins as PLY does.
bool tf_is_ply(const char *text, size_t size);

/// Reads PLY 1.0, as text or in binary of either byte order: the properties x, y
/// and perhaps z of the element `vertex`, the list vertex_indices (or
/// vertex_index) of `face` and of `tristrips`, vertex1 and vertex2 of `edge`; all
/// else is skipped.  In a list of strips -1 ends one.  In text each vertex, face
/// or edge has a line.  The text ends with a zero.
bool tf_ply_parse(tf_mesh_file *file, const char *text, size_t size);
