//: Declare how to write a mesh as PolyData
#pragma once

#include "writers/mesh_content.h"
#include "writers/polydata.h"

/// The PolyData of a mesh, which it borrows: the vertices and what they have, the
/// triangles, and the edges as lines.
tf_polydata tf_polydata_of_mesh(const tf_mesh_content *content);

/// Writes that.
void tf_vtp_write(FILE *stream, const tf_mesh_content *content);
