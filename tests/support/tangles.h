// Small tangles whose curves and regions can be told by hand.
#ifndef SUPPORT_TANGLES_H
#define SUPPORT_TANGLES_H

#include "untangle/tangle.h"

enum {
    TANGLE_VERTICES = 1000,
    TANGLE_ELEMENTS = 2000
};

/// A tangle that is made piece by piece.
typedef struct made_tangle {
    tf_mesh mesh;
    double x[3 * TANGLE_VERTICES];
    bool fixed[TANGLE_VERTICES];
    int triangle[3 * TANGLE_ELEMENTS], edge[2 * TANGLE_ELEMENTS];
    tf_surface *surface;
    tf_tangle tangle;
} made_tangle;

/// Begins with nothing, in 2 or 3 axes.
void tangle_begin(made_tangle *own, int axes);

/// Adds vertices; returns the first one.
int tangle_add(made_tangle *own, int vertices, const double x[]);

void tangle_add_triangle(made_tangle *own, int a, int b, int c);

void tangle_add_edge(made_tangle *own, int a, int b);

/// Adds a sheet of side x side vertices, vertex i u + j v + from being its
/// (side i + j)th; returns the first one.
int tangle_add_sheet(made_tangle *own, int side, const double u[3],
                     const double v[3], const double from[3]);

/// A sheet in the plane z = 0, from -6 to 6, and another one above it, of which
/// the middle is pulled through the first by a bump of some depth: vertices 0 to
/// 168 and 169 to 337.
void tangle_make_bump(made_tangle *own, double depth);

/// Makes the surface and the tangle, and checks it at x.
void tangle_finish(made_tangle *own);

/// Checks it anew at x.
void tangle_check(made_tangle *own);

void tangle_free(made_tangle *own);

#endif
