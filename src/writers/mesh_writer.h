//: Declare how to write meshes
#pragma once

#include "writers/mesh_content.h"

#include <stdio.h>

// The writers are our own, too.  Assimp writes floats, libadmesh writes STL
// alone, and VTK, which is C++ and large, keeps of OBJ and PLY what it has arrays
// for; none writes a file again as it was.  printf is slow for many numbers.

/// Writes a mesh.  If its file has a source, and is of that format, that is the
/// source with the positions of the content, or without what joining vertices
/// took away.  If not, it is written such that
/// the same triangles and edges are read, in the same order, and but for STL the
/// same vertices and doubles.  Errors are those of the stream.
void tf_mesh_write(FILE *stream, const tf_mesh_content *content,
                   tf_mesh_format format);

/// Whether that is such a source, so that nothing else is lost.
bool tf_mesh_is_source(const tf_mesh_content *content, tf_mesh_format format);

/// Whether coordinates are rounded to floats: in STL, but for text that is a
/// source.
bool tf_mesh_has_floats(const tf_mesh_content *content, tf_mesh_format format);

/// Whether a mesh can be written in a format; if not, sets the fault of the file
/// at that path.
bool tf_mesh_check_writable(const tf_mesh_content *content,
                            tf_mesh_format format, const char *path,
                            tf_fault *fault);
