//: Declare how to read a mesh file
#pragma once

#include "formats/mesh_file.h"

// The readers are our own.  Of the libraries that Debian has, assimp is compiled
// for floats, and joins and orders anew what it reads, and libgmsh reads into a
// model of its own, with a modeler of solids; neither tells a bad line or byte.
// libigl and rply are no packages; the latter reads PLY alone.

/// Reads the file at `path` ("-": standard input): OBJ, PLY, STL, OFF, or Gmsh's
/// .msh, each perhaps compressed by gzip.  Its content tells which it is, and
/// its name where that does not.  Lines may end by a line feed, a carriage
/// return, or both.  False: there is a fault.  Borrows the path, the columns and
/// the fault.  Free the file in any case.
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
/// Carriage returns that end lines become line feeds.
bool tf_mesh_file_parse(tf_mesh_file *file, const char *name, char *text,
                        size_t size, tf_columns *columns, tf_fault *fault);

/// The same, and takes the text, which must be from malloc, into the source.
/// @param source empty; NULL: the text is freed
bool tf_mesh_file_parse_all(tf_mesh_file *file, const char *name, char *text,
                            size_t size, tf_columns *columns, tf_source *source,
                            tf_fault *fault);
