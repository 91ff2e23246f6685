//: Declare how to read a mesh file
#pragma once

#include "formats/mesh_file.h"

/// Reads the file at `path` ("-": standard input), an OBJ or PLY file, told
/// apart by its content.  False: there is a fault.  Borrows the path, the columns
/// and the fault.  Free the file in any case.
/// @param columns empty; for what else the vertices have; NULL: that is skipped
bool tf_mesh_file_read(tf_mesh_file *file, const char *path,
                       tf_columns *columns, tf_fault *fault);

/// The same, and keeps the bytes of the file and where its coordinates are, so
/// that it can be written again with others.  Borrows the source; free that in
/// any case, too.
/// @param source empty; NULL: nothing is kept
bool tf_mesh_file_read_all(tf_mesh_file *file, const char *path,
                           tf_columns *columns, tf_source *source,
                           tf_fault *fault);

/// Reads `size` bytes of text, for tests and fuzzers; text[size] must be 0.
bool tf_mesh_file_parse(tf_mesh_file *file, const char *name, const char *text,
                        size_t size, tf_columns *columns, tf_fault *fault);
