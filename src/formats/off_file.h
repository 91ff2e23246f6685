//: Declare how to read OFF
#pragma once

#include "formats/mesh_file.h"

/// Whether a file begins as OFF does: with that word, perhaps after comments,
/// and after letters that tell what else vertices have, as in COFF.
bool tf_is_off(const char *text, size_t size);

/// Whether a file begins, perhaps after comments, with a number, as OFF without
/// that word does.
bool tf_is_nameless_off(const char *text, size_t size);

/// Reads OFF (of Geomview, CGAL and ModelNet), as text: the numbers of vertices,
/// faces and edges; for each vertex three coordinates, for each face the number
/// of its corners and their indices.  Each begins a line, and what else is in the
/// line (normals, colors, texture coordinates) is skipped, as are comments from #
/// on.  The text ends with a zero.
bool tf_off_parse(tf_mesh_file *file, const char *text, size_t size);
