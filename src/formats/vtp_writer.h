//: Declare how to write a mesh as PolyData
#pragma once

#include "formats/mesh_content.h"
#include "formats/polydata.h"

/// Writes VTK's PolyData: the vertices and what they have, the triangles, and
/// the edges as lines.
void tf_vtp_write(FILE *stream, const tf_mesh_content *content);
