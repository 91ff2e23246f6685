//: Include what strands need
#include "simulate/strand.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

//: Measure a strand
static double distance_between(const tf_body *body, int a, int b)
{
    double square = 0;
    for (int k = 0; k < body->axes; k++) {
        double along = body->position[(ptrdiff_t)body->axes * b + k] -
                       body->position[(ptrdiff_t)body->axes * a + k];
        square += along * along;
    }
    return sqrt(square);
}

double tf_strand_length(const tf_body *body, int edge)
{
    const int *end = body->edge + (ptrdiff_t)2 * edge;
    return distance_between(body, end[0], end[1]);
}

//: Stretch a strand
static void add_stretch_of_edge(tf_body *body, int edge,
                                const tf_material *material)
{
    const int *end = body->edge + (ptrdiff_t)2 * edge;
    double length = tf_strand_length(body, edge);
    tf_body_add_spring(body, end[0], end[1], material->stretch / length);
    for (int i = 0; i < 2 && !body->failed; i++)
        body->mass[end[i]] += material->density * length / 2;
}

//: Find the neighbors along a strand
/// The other ends of a vertex's edges.
typedef struct neighbors {
    int count; ///< of all edges there
    int vertex[2];
} neighbors;

/// Of each vertex, to be freed; NULL: there is no memory.
static neighbors *find_neighbors(const tf_body *body, int first)
{
    neighbors *of = calloc((size_t)body->vertices + 1, sizeof *of);
    for (int i = 2 * first; i < 2 * body->edges && of; i++) {
        neighbors *own = &of[body->edge[i]];
        if (own->count < 2)
            own->vertex[own->count] = body->edge[i ^ 1];
        own->count++;
    }
    return of;
}

//: Bend a strand
/// The curvature at a vertex, times the mean length of its two edges, is the
/// change of the direction, and that is nearly linear in the positions.
static void add_bend(tf_body *body, int v, const int at[2], double bend)
{
    double before = distance_between(body, v, at[0]),
           after = distance_between(body, v, at[1]);
    tf_elastic turn = {
        .count = 3,
        .vertex = {at[0], v, at[1]},
        .weight = {1 / before, -1 / before - 1 / after, 1 / after},
        .stiffness = 2 * bend / (before + after),
    };
    tf_body_add_elastic(body, &turn);
}

//: Stiffen a strand
void tf_strand_stiffen(tf_body *body, int first, const tf_material *material)
{
    neighbors *of = body->failed ? NULL : find_neighbors(body, first);
    body->failed = !of;
    for (int e = first; of && e < body->edges; e++)
        add_stretch_of_edge(body, e, material);
    for (int v = 0; of && v < body->vertices; v++)
        if (of[v].count == 2 && material->bend > 0)
            add_bend(body, v, of[v].vertex, material->bend);
    free(of);
}
