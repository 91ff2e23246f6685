#include "support/near_oracle.h"

#include "support/exact_distance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static near_oracle_pair all[NEAR_ORACLE_PAIRS];

/// Whether boxes around both elements are farther apart than the length, with a
/// margin for rounding.
static bool are_far(int axes, int first, const double *const x[], double length)
{
    for (int k = 0; k < axes; k++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i <= axes; i++) {
            low[i >= first] = fmin(low[i >= first], x[i][k]);
            high[i >= first] = fmax(high[i >= first], x[i][k]);
        }
        double gap = fmax(low[1] - high[0], low[0] - high[1]);
        if (gap * (1 - 0x1p-40) > length * (1 + 0x1p-40) && gap < INFINITY)
            return true;
    }
    return false;
}

static bool is_nearer(int axes, const near_oracle_pair *pair,
                      const double position[], double length)
{
    const double *x[4] = {NULL};
    for (int i = 0; i <= axes; i++)
        x[i] = position + (ptrdiff_t)axes * pair->vertex[i];
    tf_kind kind = (tf_kind)pair->kind;
    return !are_far(axes, kind == TF_EDGE_EDGE ? 2 : 1, x, length) &&
           exact_distance_compare(kind, x, length) < 0;
}

static bool has_own_vertices(int axes, const int vertex[])
{
    for (int i = 0; i <= axes; i++)
        for (int j = 0; j < i; j++)
            if (vertex[i] == vertex[j])
                return false;
    return true;
}

static size_t try_pair(int axes, tf_kind kind, const int first[],
                       const int second[], const double position[],
                       const double before[], double length, size_t count)
{
    near_oracle_pair pair = {(int)kind, {-1, -1, -1, -1}};
    size_t corners = kind == TF_EDGE_EDGE ? 2 : 1, both = (size_t)axes + 1;
    memcpy(pair.vertex, first, corners * sizeof *first);
    memcpy(pair.vertex + corners, second, (both - corners) * sizeof *second);
    if (!has_own_vertices(axes, pair.vertex) ||
        !is_nearer(axes, &pair, position, length) ||
        (before && is_nearer(axes, &pair, before, length)))
        return count;
    if (count == NEAR_ORACLE_PAIRS)
        abort();
    all[count] = pair;
    return count + 1;
}

const near_oracle_pair *near_oracle(const tf_surface *surface,
                                    const double position[],
                                    const double before[], double length,
                                    size_t *count)
{
    int axes = tf_surface_axes(surface), edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    const int *other = axes == 3 ? triangle : edge;
    int others = axes == 3 ? triangles : edges;
    tf_kind kind = axes == 3 ? TF_POINT_TRIANGLE : TF_POINT_EDGE;
    *count = 0;
    for (int v = 0; v < tf_surface_vertices(surface); v++)
        for (int i = 0; i < others; i++)
            *count = try_pair(axes, kind, &v, other + (ptrdiff_t)axes * i,
                              position, before, length, *count);
    for (int i = 0; i < edges && axes == 3; i++)
        for (int j = i + 1; j < edges; j++)
            *count = try_pair(axes, TF_EDGE_EDGE, edge + (ptrdiff_t)2 * i,
                              edge + (ptrdiff_t)2 * j, position, before, length,
                              *count);
    return all;
}
