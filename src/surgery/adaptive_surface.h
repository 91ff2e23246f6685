//: Declare what an adaptive surface holds
#pragma once

#include "base/watch.h"
#include "surface/buffer.h"
#include "surface/mesh.h"
#include "surgery/dynamic_tree.h"
#include "surgery/tetrahedron.h"

enum {
    TF_NONE = -1 ///< no vertex, triangle or corner
};

//: Declare what a surgery holds
/// A triangle to be added.
typedef struct tf_added_triangle {
    tf_facet facet;
    tf_aabb box;
} tf_added_triangle;

/// A tetrahedron to be swept over.
typedef struct tf_swept_tetrahedron {
    tf_tetrahedron body;
    tf_aabb box;
} tf_swept_tetrahedron;

enum {
    TF_MOST_PLACED = 3 ///< vertices that a surgery may place
};

/// A patch of the surface that is replaced by another one, and what the surface
/// sweeps over meanwhile.
typedef struct tf_surgery {
    int removals, additions, sweeps, boundary_edges;
    int placed;         ///< vertices, with the numbers after the last
    int earlier;        ///< how many of the additions, which are the first, are
                        ///< of earlier stages
    tf_buffer removed;  ///< numbers of triangles
    tf_buffer added;    ///< tf_added_triangle each
    tf_buffer swept;    ///< tf_swept_tetrahedron each
    tf_buffer boundary; ///< edges of the surface's boundary that both patches
                        ///< have: two vertices each
    int path[2];        ///< a vertex that moves, before and after, or TF_NONE
} tf_surgery;

//: Declare what else an adaptive surface lends
/// Memory for what is lent besides the surface itself.
typedef struct tf_adaptive_lent {
    tf_buffer mesh;             ///< tf_mesh: the surface
    tf_buffer remesh_report;    ///< of the last time
    tf_buffer reconnect_report; ///< of the last time
    tf_buffer origin;           ///< tf_origin of each vertex
    tf_buffer corner_origin;    ///< tf_origin of each corner
    tf_buffer defects;          ///< tf_defects: of the mesh it was made of
    tf_buffer defect;           ///< tf_error each: the list of these
    bool has_origins; ///< whether these are those of the surface as it is
} tf_adaptive_lent;

//: Hold an adaptive surface
/// The corner i of the triangle t has the number 3 t + i.
typedef struct tf_adaptive_surface {
    int vertices, triangles; ///< numbers that are or were in use
    int free_triangle;       ///< the first of a list, linked by corner 1
    tf_buffer position;      ///< of each vertex, and of those to be placed
    tf_buffer vertex;        ///< of each corner; TF_NONE: there is no triangle
    tf_buffer first;         ///< of each vertex: a corner there, or TF_NONE
    tf_buffer next;          ///< of each corner: another one at its vertex
    int marked;           ///< how many vertices, the first ones, may be frozen
    tf_buffer frozen;     ///< bool of each of these: it is left alone
    tf_dynamic_tree tree; ///< of the boxes of the triangles
    tf_buffer found;      ///< memory for a search
    tf_buffer box;        ///< memory for the boxes of all triangles
    tf_surgery surgery;   ///< that is being tried
    tf_watch *watch;      ///< over the call whose draft this is, or NULL
    double scale;         ///< of what is measured, a power of two
    tf_adaptive_lent lent;
} tf_adaptive_surface;

//: Look at an adaptive surface
static inline tf_mesh tf_mesh_of(const tf_adaptive_surface *surface)
{
    return (tf_mesh){.axes = 3,
                     .vertices = surface->vertices,
                     .triangles = surface->triangles,
                     .triangle = surface->vertex.data};
}

static inline const double *
tf_vertex_coordinates(const tf_adaptive_surface *surface, int vertex)
{
    return (const double *)surface->position.data + 3 * (ptrdiff_t)vertex;
}

static inline int tf_vertex_at(const tf_adaptive_surface *surface, int corner)
{
    return ((const int *)surface->vertex.data)[corner];
}

static inline int tf_corner_after(int corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static inline int tf_corner_before(int corner)
{
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

static inline bool tf_is_triangle(const tf_adaptive_surface *surface,
                                  int triangle)
{
    return tf_vertex_at(surface, 3 * triangle) != TF_NONE;
}

//: Go through the star of a vertex
/// The triangles at a vertex are those of the corners from the first one on
/// until TF_NONE, in no particular order.
static inline int tf_first_corner(const tf_adaptive_surface *surface,
                                  int vertex)
{
    return ((const int *)surface->first.data)[vertex];
}

static inline int tf_next_corner(const tf_adaptive_surface *surface, int corner)
{
    return ((const int *)surface->next.data)[corner];
}

//: Recognize what is frozen
/// Whether a vertex is left alone: no operation moves or removes it.
static inline bool tf_is_frozen(const tf_adaptive_surface *surface, int vertex)
{
    return vertex < surface->marked &&
           ((const bool *)surface->frozen.data)[vertex];
}

/// Whether an edge is left alone: no operation splits, collapses or flips it.
static inline bool tf_is_frozen_edge(const tf_adaptive_surface *surface, int a,
                                     int b)
{
    return tf_is_frozen(surface, a) && tf_is_frozen(surface, b);
}

//: View triangles as facets
static inline tf_facet tf_facet_of(const tf_adaptive_surface *surface,
                                   const int vertex[3])
{
    tf_facet facet;
    for (int i = 0; i < 3; i++) {
        facet.vertex[i] = vertex[i];
        facet.corner[i] = tf_vertex_coordinates(surface, vertex[i]);
    }
    return facet;
}

static inline const int *tf_triangle(const tf_adaptive_surface *surface,
                                     int triangle)
{
    return (const int *)surface->vertex.data + 3 * (ptrdiff_t)triangle;
}

static inline tf_aabb tf_aabb_of(const tf_adaptive_surface *surface, int count,
                                 const int vertex[])
{
    tf_aabb box = tf_aabb_empty();
    for (int i = 0; i < count; i++)
        tf_aabb_add(&box, tf_vertex_coordinates(surface, vertex[i]));
    return box;
}
