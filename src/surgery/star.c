//: Find an edge
#include "surgery/star.h"

#include <limits.h>
#include <string.h>

int tf_find_edge(const tf_adaptive_surface *surface, int from, int to)
{
    int corner = tf_first_corner(surface, from);
    while (corner != TF_NONE &&
           tf_vertex_at(surface, tf_corner_after(corner)) != to)
        corner = tf_next_corner(surface, corner);
    return corner;
}

//: Recognize the boundary
bool tf_is_boundary_edge(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    return tf_find_edge(surface, to, from) == TF_NONE;
}

bool tf_is_isolated(const tf_adaptive_surface *surface, int triangle)
{
    return tf_is_boundary_edge(surface, 3 * triangle) &&
           tf_is_boundary_edge(surface, 3 * triangle + 1) &&
           tf_is_boundary_edge(surface, 3 * triangle + 2);
}

bool tf_is_boundary_vertex(const tf_adaptive_surface *surface, int vertex)
{
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        if (tf_is_boundary_edge(surface, c))
            return true;
    return false;
}

//: Count triangles and neighbors
int tf_star_size(const tf_adaptive_surface *surface, int vertex)
{
    int count = 0, c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        count++;
    return count;
}

static bool are_neighbors(const tf_adaptive_surface *surface, int a, int b)
{
    return tf_find_edge(surface, a, b) != TF_NONE ||
           tf_find_edge(surface, b, a) != TF_NONE;
}

/// Each neighbor follows the vertex in one triangle, except for one, on the
/// boundary, that only precedes it.
int tf_common_neighbors(const tf_adaptive_surface *surface, int a, int b)
{
    int count = 0, c = tf_first_corner(surface, a);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        int before = tf_corner_before(c);
        count += are_neighbors(surface,
                               tf_vertex_at(surface, tf_corner_after(c)), b);
        count += tf_is_boundary_edge(surface, before) &&
                 are_neighbors(surface, tf_vertex_at(surface, before), b);
    }
    return count;
}

//: Make room for elements
bool tf_adaptive_reserve(tf_adaptive_surface *surface, int vertices,
                         int triangles, int more)
{
    if (more > INT_MAX / 3 - triangles || vertices > INT_MAX - TF_MOST_PLACED)
        return false;
    size_t points = (size_t)vertices + TF_MOST_PLACED;
    size_t count = (size_t)triangles + (size_t)more;
    return tf_buffer_extend(&surface->position, points, 3 * sizeof(double)) &&
           tf_buffer_extend(&surface->first, points, sizeof(int)) &&
           tf_buffer_extend(&surface->vertex, count, 3 * sizeof(int)) &&
           tf_buffer_extend(&surface->next, count, 3 * sizeof(int)) &&
           tf_buffer_extend(&surface->found, count, sizeof(int)) &&
           tf_dynamic_tree_reserve(&surface->tree, triangles + more);
}

//: Link the corners of a triangle
static void link_corner(tf_adaptive_surface *surface, int corner)
{
    int *first = (int *)surface->first.data + tf_vertex_at(surface, corner);
    ((int *)surface->next.data)[corner] = *first;
    *first = corner;
}

static void unlink_corner(tf_adaptive_surface *surface, int corner)
{
    int *link = (int *)surface->first.data + tf_vertex_at(surface, corner);
    while (*link != corner)
        link = (int *)surface->next.data + *link;
    *link = tf_next_corner(surface, corner);
}

//: Link all triangles
static void link_triangle(tf_adaptive_surface *surface, int triangle)
{
    for (int i = 0; i < 3; i++)
        link_corner(surface, 3 * triangle + i);
}

bool tf_stars_build(tf_adaptive_surface *surface, tf_aabb box[])
{
    int *order = surface->found.data;
    surface->free_triangle = TF_NONE;
    surface->lent.has_origins = false;
    for (int v = 0; v < surface->vertices; v++)
        ((int *)surface->first.data)[v] = TF_NONE;
    for (int t = surface->triangles - 1; t >= 0; t--) {
        link_triangle(surface, t);
        box[t] = tf_aabb_of(surface, 3, tf_triangle(surface, t));
        order[t] = t;
        if (t % 1024 == 0 && !tf_watch_done(surface->watch, 0))
            return false;
    }
    return tf_dynamic_tree_build(&surface->tree, box, order, surface->triangles,
                                 surface->watch);
}

//: Add and remove triangles
static int take_number(tf_adaptive_surface *surface)
{
    int taken = surface->free_triangle;
    if (taken == TF_NONE)
        return surface->triangles++;
    surface->free_triangle = tf_vertex_at(surface, 3 * taken + 1);
    return taken;
}

int tf_triangle_add(tf_adaptive_surface *surface, const int vertex[3])
{
    surface->lent.has_origins = false;
    int added = take_number(surface);
    for (int i = 0; i < 3; i++) {
        ((int *)surface->vertex.data)[3 * added + i] = vertex[i];
        link_corner(surface, 3 * added + i);
    }
    tf_dynamic_tree_insert(&surface->tree, added,
                           tf_aabb_of(surface, 3, vertex));
    return added;
}

void tf_triangle_remove(tf_adaptive_surface *surface, int triangle)
{
    int *vertex = (int *)surface->vertex.data + 3 * (ptrdiff_t)triangle;
    surface->lent.has_origins = false;
    for (int i = 0; i < 3; i++)
        unlink_corner(surface, 3 * triangle + i);
    tf_dynamic_tree_remove(&surface->tree, triangle);
    vertex[0] = vertex[2] = TF_NONE;
    vertex[1] = surface->free_triangle;
    surface->free_triangle = triangle;
}

//: Put a vertex elsewhere
void tf_vertex_put(tf_adaptive_surface *surface, int vertex,
                   const double position[3])
{
    surface->lent.has_origins = false;
    memcpy((double *)surface->position.data + 3 * (ptrdiff_t)vertex, position,
           3 * sizeof *position);
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        tf_dynamic_tree_change(
            &surface->tree, c / 3,
            tf_aabb_of(surface, 3, tf_triangle(surface, c / 3)));
}
