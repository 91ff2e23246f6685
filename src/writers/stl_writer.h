//: Declare how to write STL
#pragma once

#include "writers/mesh_content.h"

#include <stdio.h>

/// Writes binary STL: the triangles alone, their coordinates rounded to floats,
/// and their normals.
void tf_stl_write(FILE *stream, const tf_mesh_content *content);
