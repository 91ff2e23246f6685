//: Declare how to write OFF
#pragma once

#include "writers/mesh_content.h"

#include <stdio.h>

/// Writes OFF: vertices and faces; COFF if the vertices have colors, which are
/// integers from 0 to 255 if those of the columns are bytes, or else numbers
/// from 0 to 1, and opaque.
void tf_off_write(FILE *stream, const tf_mesh_content *content);
