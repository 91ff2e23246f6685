//: Declare how to write meshes
#pragma once

#include "formats/mesh_file.h"

#include <stdio.h>

/// What is written of a mesh.
typedef struct tf_mesh_content {
    tf_mesh mesh;              ///< the elements; in the plane z is 0
    const double *position;    ///< of each vertex
    const double *velocity;    ///< the properties vx, vy and vz of PLY; or NULL
    const char *comment;       ///< a line of the header of PLY; or NULL
    const tf_columns *columns; ///< what else each vertex has, in space; or
                               ///< NULL.  OBJ has red, green and blue alone
} tf_mesh_content;

/// The format of a file with that name: OBJ or PLY if it ends in .obj or .ply,
/// which of those of PLY depends on the usual one; else the usual one.
tf_mesh_format tf_mesh_format_of(const char *path, tf_mesh_format usual);

/// What the names of files of that format end in.
const char *tf_mesh_ending(tf_mesh_format format);

/// Writes a mesh such that it is read as the same doubles, triangles and edges,
/// in the same order.  Errors are those of the stream.
void tf_mesh_write(FILE *stream, const tf_mesh_content *content,
                   tf_mesh_format format);
