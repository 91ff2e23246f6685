//: Declare the endings of names
#pragma once

#include "formats/mesh_file.h"

/// The format of a file with that name, after its ending, before .gz if it ends
/// so: which of those of PLY or STL depends on the usual one, if that is one of
/// them.  The usual one if the ending says nothing.
tf_mesh_format tf_mesh_format_of(const char *path, tf_mesh_format usual);

/// What the names of files of a format end in: ".ply".
const char *tf_mesh_ending(tf_mesh_format format);

/// What a format is called: "PLY".
const char *tf_mesh_format_name(tf_mesh_format format);

/// Whether a name ends so, in small or capital letters, before .gz if it ends so.
bool tf_ends_in(const char *path, const char *ending);

/// The ending of a name if it is that of a mesh, in a format that is written or
/// in another one; or NULL.
const char *tf_any_mesh_ending(const char *path);

/// The ending of a name if it is that of a format in which no single mesh is
/// written; or NULL.
const char *tf_unwritten_ending(const char *path);
