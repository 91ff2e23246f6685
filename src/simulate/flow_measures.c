//: Include what measures of surfaces need
#include "simulate/flow_measures.h"

#include "geometry/vector.h"

#include <stdint.h>
#include <stdlib.h>

//: List the sides of triangles
/// A side of a triangle as a number, the higher vertex in its lower half.
static uint64_t side_of(int a, int b)
{
    return a < b ? (uint64_t)a << 32 | (uint64_t)b
                 : (uint64_t)b << 32 | (uint64_t)a;
}

static int compare_sides(const void *first, const void *second)
{
    uint64_t a = *(const uint64_t *)first, b = *(const uint64_t *)second;
    return (a > b) - (a < b);
}

static void list_sides(const tf_mesh *mesh, uint64_t side[])
{
    for (int i = 0; i < 3 * mesh->triangles; i++)
        side[i] = side_of(mesh->triangle[i],
                          mesh->triangle[i % 3 == 2 ? i - 2 : i + 1]);
    qsort(side, 3 * (size_t)mesh->triangles, sizeof *side, compare_sides);
}

//: Join vertices
/// Each vertex leads to another one of its set, and the last one to itself.
static int last_of(int lead[], int v)
{
    while (lead[v] != v)
        v = lead[v] = lead[lead[v]];
    return v;
}

/// Returns whether the ends of a side were in different sets.
static int join_ends(int lead[], uint64_t side)
{
    int one = last_of(lead, (int)(side >> 32));
    int other = last_of(lead, (int)(side & UINT32_MAX));
    lead[one] = other;
    return one != other;
}

static void part_sets(int lead[], int vertices)
{
    for (int v = 0; v < vertices; v++)
        lead[v] = v;
}

//: Measure how a surface is connected
/// By Euler's formula: each edge is two sides, or one on a boundary.
static void measure_topology(const tf_mesh *mesh, const uint64_t side[],
                             int lead[], tf_flow_measures *measures)
{
    int sides = 3 * mesh->triangles, lone = 0;
    measures->components = mesh->vertices;
    part_sets(lead, mesh->vertices);
    for (int i = 0; i < sides; i++)
        measures->components -= join_ends(lead, side[i]);
    // A loop is closed by the edge that joins nothing.
    part_sets(lead, mesh->vertices);
    for (int i = 0; i < sides; i++)
        if ((i == 0 || side[i] != side[i - 1]) &&
            (i + 1 == sides || side[i] != side[i + 1])) {
            lone++;
            measures->boundaries += !join_ends(lead, side[i]);
        }
    int euler = mesh->vertices - (sides + lone) / 2 + mesh->triangles;
    measures->genus =
        (2 * measures->components - measures->boundaries - euler) / 2;
}

//: Measure how large a surface is
static void measure_size(const tf_mesh *mesh, const double position[],
                         tf_flow_measures *measures)
{
    tf_vector origin = tf_vector_at(position, mesh->triangle[0]), corner[3];
    for (int i = 0; i < 3 * mesh->triangles; i += 3) {
        for (int k = 0; k < 3; k++)
            corner[k] = tf_vector_difference(
                tf_vector_at(position, mesh->triangle[i + k]), origin);
        tf_vector normal =
            tf_vector_cross(tf_vector_difference(corner[1], corner[0]),
                            tf_vector_difference(corner[2], corner[0]));
        measures->area += tf_vector_length(normal) / 2;
        measures->volume += tf_vector_dot(corner[0], normal) / 6;
    }
}

//: Measure a surface
bool tf_flow_measure(const tf_adaptive_surface *surface,
                     tf_flow_measures *measures)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    *measures = (tf_flow_measures){.vertices = mesh.vertices,
                                   .triangles = mesh.triangles};
    uint64_t *side = malloc(3 * sizeof *side * (size_t)(mesh.triangles + 1));
    int *lead = malloc(sizeof *lead * (size_t)(mesh.vertices + 1));
    bool good = side && lead;
    if (good && mesh.triangles > 0) {
        list_sides(&mesh, side);
        measure_topology(&mesh, side, lead, measures);
        measure_size(&mesh, tf_adaptive_positions(surface), measures);
        if (measures->boundaries > 0)
            measures->volume = 0;
    }
    free(side);
    free(lead);
    return good;
}
