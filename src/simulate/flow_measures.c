//: Include what measures of surfaces need
#include "simulate/flow_measures.h"

#include "geometry/vector.h"

#include <stdlib.h>

//: List the sides of triangles
/// A side of a triangle, the vertex with the lower number first.
typedef struct side_row {
    int low, high;
} side_row;

static int compare_sides(const void *first, const void *second)
{
    const side_row *a = first, *b = second;
    return a->low != b->low ? (a->low > b->low) - (a->low < b->low)
                            : (a->high > b->high) - (a->high < b->high);
}

static void list_sides(const tf_mesh *mesh, side_row row[])
{
    for (int i = 0; i < 3 * mesh->triangles; i++) {
        int a = mesh->triangle[i];
        int b = mesh->triangle[i % 3 == 2 ? i - 2 : i + 1];
        row[i] = a < b ? (side_row){a, b} : (side_row){b, a};
    }
    qsort(row, 3 * (size_t)mesh->triangles, sizeof *row, compare_sides);
}

//: Join vertices
/// Each vertex leads to another one of its set, and the last one to itself.
static int last_of(int lead[], int v)
{
    while (lead[v] != v)
        v = lead[v] = lead[lead[v]];
    return v;
}

/// Returns whether they were in different sets.
static int join_sets(int lead[], int a, int b)
{
    int one = last_of(lead, a), other = last_of(lead, b);
    lead[one] = other;
    return one != other;
}

static void part_sets(int lead[], int vertices)
{
    for (int v = 0; v < vertices; v++)
        lead[v] = v;
}

//: Measure how a surface is connected
/// By Euler's formula: each edge is two sides, or one on a rim.
static void measure_topology(const tf_mesh *mesh, const side_row row[],
                             int lead[], tf_flow_measures *measures)
{
    int sides = 3 * mesh->triangles, edges = 0, loops = 0;
    measures->components = mesh->vertices;
    part_sets(lead, mesh->vertices);
    for (int i = 0; i < sides; i++) {
        if (i > 0 && compare_sides(&row[i], &row[i - 1]) == 0)
            continue;
        measures->components -= join_sets(lead, row[i].low, row[i].high);
        edges++;
    }
    // A loop is closed by the edge that joins nothing.
    part_sets(lead, mesh->vertices);
    for (int i = 0; i < sides; i++)
        if ((i == 0 || compare_sides(&row[i], &row[i - 1]) != 0) &&
            (i + 1 == sides || compare_sides(&row[i], &row[i + 1]) != 0))
            loops += !join_sets(lead, row[i].low, row[i].high);
    measures->rims = loops;
    int euler = mesh->vertices - edges + mesh->triangles;
    measures->genus = (2 * measures->components - loops - euler) / 2;
}

//: Measure how large a surface is
static void measure_size(const tf_mesh *mesh, const double position[],
                         tf_flow_measures *measures)
{
    tf_vector origin = tf_vector_at(position, mesh->triangle[0]);
    for (const int *v = mesh->triangle;
         v < mesh->triangle + (ptrdiff_t)3 * mesh->triangles; v += 3) {
        tf_vector a =
            tf_vector_difference(tf_vector_at(position, v[0]), origin);
        tf_vector b =
            tf_vector_difference(tf_vector_at(position, v[1]), origin);
        tf_vector c =
            tf_vector_difference(tf_vector_at(position, v[2]), origin);
        tf_vector normal = tf_vector_cross(tf_vector_difference(b, a),
                                           tf_vector_difference(c, a));
        measures->area += tf_vector_length(normal) / 2;
        measures->volume += tf_vector_dot(a, normal) / 6;
    }
}

//: Measure a surface
bool tf_flow_measure(const tf_adaptive_surface *surface,
                     tf_flow_measures *measures)
{
    tf_mesh mesh = tf_adaptive_mesh(surface);
    *measures = (tf_flow_measures){.vertices = mesh.vertices,
                                   .triangles = mesh.triangles};
    side_row *row = malloc(3 * sizeof *row * (size_t)(mesh.triangles + 1));
    int *lead = malloc(sizeof *lead * (size_t)(mesh.vertices + 1));
    bool good = row && lead;
    if (good && mesh.triangles > 0) {
        list_sides(&mesh, row);
        measure_topology(&mesh, row, lead, measures);
        measure_size(&mesh, tf_adaptive_positions(surface), measures);
        if (measures->rims > 0)
            measures->volume = 0;
    }
    free(row);
    free(lead);
    return good;
}
