//: Declare what is next to what
#pragma once

#include "geometry/vector.h"
#include "surface/buffer.h"
#include "surface/surface.h"

#include <stdbool.h>

/// Lists of items, one list after another: those of list i are item[start[i]] to
/// item[start[i + 1] - 1].
typedef struct tf_lists {
    int *start, *item;
} tf_lists;

/// What is next to what in a surface.  Elements have the numbers of
/// tf_surface_edges and tf_surface_triangles, whose lists are borrowed.  Its facets
/// are what edges pass through: triangles, and in the plane edges.
typedef struct tf_neighbors {
    int axes, vertices, edges, triangles, facets;
    const int *edge, *triangle; ///< two and three vertices each
    const int *facet;           ///< `axes` vertices each
    tf_lists around;            ///< of each vertex: its neighbors, increasing
    tf_lists edges_at;     ///< of each vertex: its edges, to these neighbors
    tf_lists triangles_at; ///< of each vertex: its triangles, increasing
    tf_lists facets_at;    ///< of each vertex: one of these two
    tf_lists sides;        ///< of each edge: its triangles, any number of them
    int parts;             ///< connected parts, particles not counted
    int *part;             ///< of each vertex: its part; -1: it is a particle
    int sheets; ///< sets of triangles that are connected by edges, in the plane
                ///< of edges that are connected by vertices
    int *sheet; ///< of each facet
    signed char *turn; ///< of each facet: 1, or -1 to turn it around, so that
                       ///< the facets of a sheet have one side up if they can;
                       ///< the first of a sheet is not turned
    tf_buffer counts, turns;
} tf_neighbors;

/// Finds what is next to what.  False if there is no memory; frees nothing.
bool tf_neighbors_find(tf_neighbors *all, const tf_surface *surface);

void tf_neighbors_free(tf_neighbors *all);

//: Declare how to find elements
/// The number of an edge or a triangle, by its vertices in any order; -1 if there
/// is none.
int tf_edge_of(const tf_neighbors *all, int a, int b);
int tf_triangle_of(const tf_neighbors *all, int a, int b, int c);

/// How many items a list has.
static inline int tf_list_length(const tf_lists *lists, int list)
{
    return lists->start[list + 1] - lists->start[list];
}

/// Whether an edge is at the boundary of a surface: it has one triangle.
static inline bool tf_is_boundary(const tf_neighbors *all, int edge)
{
    return tf_list_length(&all->sides, edge) == 1;
}

//: Declare positions in space and in the plane
/// Where a vertex is; `x` has `axes` coordinates of each.
static inline tf_vector tf_place(const tf_neighbors *all, const double x[],
                                 int vertex)
{
    x += (ptrdiff_t)all->axes * vertex;
    return (tf_vector){{x[0], x[1], all->axes == 3 ? x[2] : 0}};
}

/// Moves a vertex there.
static inline void tf_put(const tf_neighbors *all, double x[], int vertex,
                          tf_vector place)
{
    x += (ptrdiff_t)all->axes * vertex;
    for (int k = 0; k < all->axes; k++)
        x[k] = place.x[k];
}

//: Declare the sizes of edges
/// The mean length of all edges; and unless `around` is NULL, of each vertex the
/// mean length of its edges, 0 without edges.
double tf_mean_edge(const tf_neighbors *all, const double x[], double around[]);

/// The power of two k such that the largest coordinate times 2^-k is at least 1
/// and less than 2; 0 if all are 0.
int tf_scale_of(size_t coordinates, const double x[]);

/// Scales coordinates by 2^power: to[i] = from[i] 2^power.
void tf_scale_by(size_t coordinates, const double from[], int power,
                 double to[]);

/// The unit normal of a facet as its sheet turns it, or zero.
tf_vector tf_facet_normal(const tf_neighbors *all, const double x[], int facet);
