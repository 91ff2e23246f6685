// Meshes of triangles that figures show.
#ifndef FIG_MESHES_H
#define FIG_MESHES_H

#include "surface/surface.h"

/// A mesh with its vertices in one position; its arrays are its own.
typedef struct fig_some_mesh {
    int vertices, triangles;
    double *x;     ///< three coordinates a vertex
    int *triangle; ///< three vertices each
} fig_some_mesh;

/// A disc of radius 1 around the origin, with 6 k vertices on the k-th of its
/// rings; bent to the saddle z = height (x^2 - y^2).
fig_some_mesh fig_disc(int rings, double height);

/// A sheet that is folded over, in rows along the fold and columns across it:
/// half of it lies flat, and the other half rises at an angle, in degrees, and
/// is wavy.  Each of the squares is cut in two.
fig_some_mesh fig_folded_sheet(int rows, int columns, double angle);

void fig_some_mesh_free(fig_some_mesh *mesh);

/// The mesh as the library has it, borrowed.
tf_mesh fig_mesh_in_space(const fig_some_mesh *mesh);

#endif
