//: Declare how to write OBJ
#pragma once

#include "writers/mesh_content.h"

#include <stdio.h>

/// Writes Wavefront OBJ: vertices with their colors, faces with what they have,
/// and edges.
void tf_obj_write(FILE *stream, const tf_mesh_content *content);
