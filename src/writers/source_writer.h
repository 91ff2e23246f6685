//: Declare how to write a source
#pragma once

#include "formats/mesh_file.h"

#include <stdio.h>

/// Writes the source of a file again, byte by byte, with these coordinates of
/// its vertices, three each.  In text, one that is still the same double keeps
/// its spelling, and another is written with as few digits as determine it.  The
/// properties x, y and z of PLY become double if their types do not hold what is
/// new, and a z is added that is not 0.  The floats of binary STL are rounded.
/// Errors are those of the stream.
void tf_source_write(FILE *stream, const tf_mesh_file *file,
                     const double position[]);
