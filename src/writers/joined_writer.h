//: Declare how to write a source of joined vertices
#pragma once

#include "writers/mesh_content.h"

#include <stdio.h>

/// Whether the source of content->joined can be written again: it has kept its
/// parts, and in PLY each face has all of its corners or is gone.
bool tf_joined_is_writable(const tf_mesh_content *content);

/// Writes that source again, byte by byte, without vertices that are not kept
/// and the elements that are gone, and with the new numbers of all others.  In
/// OBJ, faces and edges that have lost corners are written anew, with what
/// follows the numbers of the others.  Errors are those of the stream.
void tf_joined_write(FILE *stream, const tf_mesh_content *content);
