//: Declare how to write meshes
#pragma once

#include "files/mesh_file.h"

#include <stdio.h>

/// The format of a file with that name: OBJ or PLY if it ends in .obj or .ply,
/// which of those of PLY depends on the usual one; else the usual one.
tf_mesh_format tf_mesh_format_of(const char *path, tf_mesh_format usual);

/// Writes a mesh such that it is read as the same doubles, triangles and edges,
/// in the same order.  Errors are those of the stream.
void tf_mesh_write(FILE *stream, const tf_mesh_file *mesh,
                   tf_mesh_format format);

//: Declare how to write meshes that move
/// What binary PLY can hold besides a mesh.
typedef struct tf_mesh_state {
    const char *comment; ///< a line of the header
    const double
        *velocity; ///< three coordinates a vertex: vx, vy and vz; NULL:
                   ///< there are none
} tf_mesh_state;

/// Writes a mesh as PLY, little-endian, with that.
/// Errors are those of the stream.
void tf_mesh_write_state(FILE *stream, const tf_mesh_file *mesh,
                         const tf_mesh_state *state);
