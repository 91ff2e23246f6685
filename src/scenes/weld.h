//: Declare how to weld a mesh
#pragma once

#include "formats/mesh_file.h"

/// What it took to weld a mesh.
typedef struct tf_weld_report {
    int vertices_before, vertices;
    int joined; ///< vertices that were replaced by another one
    int triangles_before, triangles;
    int collapsed; ///< triangles two corners of which are now one vertex
    int edges_before, edges;
    int collapsed_edges;
    double farthest; ///< how far a vertex was moved at the most
} tf_weld_report;

/// Makes the mesh in which each vertex of a file is replaced by the one that it
/// coincides with; see tf_find_coincident.  Triangles and edges that collapse
/// are left out, and corners of polygons; and then vertices that have lost all
/// their elements.  All else stays in its order.
/// @param within at least tf_least_within, or 0
/// @param columns what the vertices of the file have besides; the file's own, or
///     NULL
/// @param[out] number of each vertex of the file, the one that it has now, or -1
/// @param[out] welded the mesh, with the name and the format of the file; to be
///     freed in any case
/// @param[out] carried its columns, empty at first
/// @return false: there is a fault of the file
bool tf_weld(const tf_mesh_file *file, double within, const tf_columns *columns,
             int number[], tf_mesh_file *welded, tf_columns *carried,
             tf_weld_report *report);
