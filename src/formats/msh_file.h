//: Declare how to read Gmsh's format
#pragma once

#include "formats/mesh_file.h"

/// Whether a file begins as Gmsh's do.
bool tf_is_msh(const char *text, size_t size);

/// Reads Gmsh's format .msh, version 2 or 4.1, as text or in binary of either
/// byte order: all nodes, in the order of the file, whatever their tags, and the
/// triangles and quadrangles.  If there are none, the lines are edges.  Other
/// elements are counted as left out; curved surfaces are refused.  The text ends
/// with a zero.
bool tf_msh_parse(tf_mesh_file *file, const char *text, size_t size);
