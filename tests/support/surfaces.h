// Surfaces to try: small, random, and mostly degenerate.
#ifndef SUPPORT_SURFACES_H
#define SUPPORT_SURFACES_H

#include "query/motion.h"
#include "support/generator.h"
#include "surface/mesh.h"

enum {
    SURFACE_VERTICES = 400,
    SURFACE_ELEMENTS = 200
};

/// A mesh with a step, which are lent by it.
typedef struct surface_case {
    tf_mesh mesh;
    tf_motion motion;
    int triangle[3 * SURFACE_ELEMENTS], edge[2 * SURFACE_ELEMENTS];
    double start[3 * SURFACE_VERTICES], end[3 * SURFACE_VERTICES];
} surface_case;

/// How the vertices of a surface are placed.
typedef enum placement {
    ANYWHERE,      ///< in a cube
    ON_LATTICE,    ///< small integers
    IN_PLANE,      ///< a lattice, with one coordinate the same for all
    IN_POINT,      ///< all in one place, or nearly all
    AT_REST,       ///< anywhere, and not moving
    HUGE_AND_TINY, ///< subnormal to nearly the largest doubles
    TOGETHER       ///< at any scale, shifted, turned and stretched as a whole
} placement;

enum {
    PLACEMENTS = TOGETHER + 1
};

/// Fills `made`: soups, strips and closed surfaces, with edges of no triangle,
/// particles, repeated elements and several parts; of up to `elements`
/// triangles, or in the plane edges.
void random_surface(generator *random, int axes, int elements, placement placed,
                    surface_case *made);

#endif
