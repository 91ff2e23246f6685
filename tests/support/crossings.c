#include "support/crossings.h"

#include "support/oracle.h"

#include <check.h>
#include <stdbool.h>
#include <string.h>

/// Whether two elements at rest meet.
static bool meet(const oracle_crossings *all, int count, const int a[],
                 int others, const int b[])
{
    tf_event event[2][3];
    oracle_simplex simplex[2] = {{.count = count}, {.count = others}};
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < simplex[s].count; i++) {
            int v = s == 0 ? a[i] : b[i];
            event[s][i] = (tf_event){.vertex = TF_NO_INDEX};
            memcpy(event[s][i].x, all->position + all->axes * v,
                   sizeof(double) * (size_t)all->axes);
            simplex[s].event[i] = &event[s][i];
        }
    return oracle_slices_meet(all->axes, &simplex[0], &simplex[1]);
}

/// Whether an edge passes through the inside of a triangle: they meet, but not
/// at the ends of the one nor at the edges of the other.
static bool pass(const oracle_crossings *all, const int edge[],
                 const int triangle[])
{
    if (!meet(all, 2, edge, 3, triangle) ||
        meet(all, 1, &edge[0], 3, triangle) ||
        meet(all, 1, &edge[1], 3, triangle))
        return false;
    for (int i = 0; i < 3; i++) {
        int side[] = {triangle[i], triangle[(i + 1) % 3]};
        if (meet(all, 2, edge, 2, side))
            return false;
    }
    return true;
}

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

static void try_pair(oracle_crossings *all, tf_crossing_kind kind, int count,
                     const int a[], int others, const int b[])
{
    if (share(count, a, others, b) ||
        !(kind == TF_EDGE_THROUGH_TRIANGLE ? pass(all, a, b)
                                           : meet(all, count, a, others, b)))
        return;
    tf_crossing *row = &all->row[all->count++];
    ck_assert_int_lt(all->count, MOST_CROSSINGS);
    *row = (tf_crossing){kind, {-1, -1, -1, -1, -1}};
    memcpy(row->vertex, a, sizeof *a * (size_t)count);
    memcpy(row->vertex + count, b, sizeof *b * (size_t)others);
}

void oracle_crossings_find(oracle_crossings *all, const tf_surface *surface,
                           int axes, int vertices, const double position[])
{
    int edges, triangles;
    const int *edge = tf_surface_edges(surface, &edges);
    const int *triangle = tf_surface_triangles(surface, &triangles);
    all->axes = axes;
    all->position = position;
    all->count = 0;
    for (int i = 0; i < edges; i++)
        for (int j = 0; j < triangles; j++)
            try_pair(all, TF_EDGE_THROUGH_TRIANGLE, 2, edge + 2 * i, 3,
                     triangle + 3 * j);
    for (int v = 0; v < vertices; v++)
        for (int j = 0; j < triangles; j++)
            try_pair(all, TF_POINT_ON_TRIANGLE, 1, &v, 3, triangle + 3 * j);
    for (int i = 0; i < edges; i++)
        for (int j = i + 1; j < edges; j++)
            try_pair(all, TF_EDGE_ON_EDGE, 2, edge + 2 * i, 2, edge + 2 * j);
}
