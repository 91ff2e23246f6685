// Stripes along the border of cloth, by which the eye follows its folds.
#include "kit/cloth_parts.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

/// Where stripes begin and end, from the border, 0, to what is farthest from it,
/// 1.
static const double wide[2] = {0.14, 0.24}, thin[2] = {0.31, 0.35};

/// The rings of triangles from `begin` on, up to `end`.
typedef struct stripe {
    int begin, end;
} stripe;

/// A stripe of at least one ring, and not at the border.
static stripe stripe_of(const double reach[2], int rings)
{
    int begin = (int)lround(reach[0] * rings);
    int end = (int)lround(reach[1] * rings);
    begin = begin < 1 ? 1 : begin;
    return (stripe){begin, end > begin ? end : begin + 1};
}

static bool is_in(stripe s, int ring)
{
    return ring >= s.begin && ring < s.end;
}

/// What is coarse has one stripe, or none.
static bool is_hem(int ring, int rings)
{
    stripe outer = stripe_of(wide, rings), inner = stripe_of(thin, rings);
    if (outer.end >= rings)
        return false;
    return is_in(outer, ring) ||
           (inner.begin > outer.end && is_in(inner, ring));
}

static void begin_at_border(const fig_shape *shape, int ring[])
{
    for (int v = 0; v < shape->vertices; v++)
        ring[v] = INT_MAX;
    for (int i = 0; i < shape->edges; i++)
        if (shape->degree[i] == 1)
            ring[shape->edge[2 * (size_t)i]] =
                ring[shape->edge[2 * (size_t)i + 1]] = 0;
}

/// Bring an end of an edge as close to the border as the other one, but for one
/// ring; whether that changes anything.
static bool pass_along(int ring[], const int end[2])
{
    int *a = &ring[end[0]], *b = &ring[end[1]];
    int *far = *a > *b ? a : b, near = *a > *b ? *b : *a;
    bool farther = near<INT_MAX && * far> near + 1;
    if (farther)
        *far = near + 1;
    return farther;
}

/// Count for each vertex the edges on the shortest way to the border.
static void count_rings(const fig_shape *shape, int ring[])
{
    begin_at_border(shape, ring);
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < shape->edges; i++)
            changed |= pass_along(ring, shape->edge + 2 * (size_t)i);
    }
}

static int ring_of(const int ring[], const int corner[3])
{
    int least = ring[corner[0]];
    for (int c = 1; c < 3; c++)
        least = ring[corner[c]] < least ? ring[corner[c]] : least;
    return least;
}

bool fig_cloth_find_hems(fig_cloth *cloth)
{
    const fig_shape *shape = &cloth->shape;
    int *ring = malloc(((size_t)shape->vertices + 1) * sizeof *ring);
    int *rings = calloc((size_t)shape->parts + 1, sizeof *rings);
    bool good = ring && rings;
    if (good)
        count_rings(shape, ring);
    for (int i = 0; i < shape->triangles && good; i++) {
        const int *corner = shape->triangle + 3 * (size_t)i;
        int own = ring_of(ring, corner), *most = &rings[shape->part[*corner]];
        if (own < INT_MAX && own >= *most)
            *most = own + 1;
    }
    for (int i = 0; i < shape->triangles && good; i++) {
        const int *corner = shape->triangle + 3 * (size_t)i;
        int part = shape->part[*corner], own = ring_of(ring, corner);
        cloth->hem[i] = cloth->soft[part] && is_hem(own, rings[part]);
    }
    free(ring);
    free(rings);
    return good;
}
