//: Declare how to read STL
#pragma once

#include "formats/mesh_file.h"

/// Whether a file is STL in binary: it has as many bytes as its header tells,
/// whatever that begins with; or as text: it begins with the word solid.
bool tf_is_binary_stl(const char *text, size_t size);
bool tf_is_text_stl(const char *text, size_t size);

/// Whether there are more bytes than a file of STL in binary would have.
bool tf_is_above_binary_stl(const char *text, size_t size);

/// Read STL.  Corners at the same position, to the last bit (-0 and 0 are the
/// same), are one vertex; vertices are in the order in which they first appear.
/// Triangles with two corners at one position have no area, and are left out.
/// Normals, colors and names are skipped.  In text letters may be capitals, and
/// several solids may follow each other.  The text ends with a zero.
bool tf_binary_stl_parse(tf_mesh_file *file, const char *text, size_t size);
bool tf_text_stl_parse(tf_mesh_file *file, const char *text, size_t size);
