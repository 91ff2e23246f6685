//: Declare how to write PLY
#pragma once

#include "writers/mesh_content.h"

#include <stdio.h>

/// Writes PLY in one of its formats: vertices with their columns and velocities,
/// faces and edges.
void tf_ply_write(FILE *stream, const tf_mesh_content *content,
                  tf_mesh_format format);
