//: Find an edge
#include "surgery/star.h"

int tf_find_edge(const tf_adaptive *of, int from, int to)
{
    int corner = tf_first_corner(of, from);
    while (corner != TF_NONE && tf_vertex_at(of, tf_corner_after(corner)) != to)
        corner = tf_next_corner(of, corner);
    return corner;
}

//: Recognize the boundary
bool tf_is_bare(const tf_adaptive *of, int corner)
{
    int from = tf_vertex_at(of, corner);
    int to = tf_vertex_at(of, tf_corner_after(corner));
    return tf_find_edge(of, to, from) == TF_NONE;
}

bool tf_is_lone(const tf_adaptive *of, int triangle)
{
    return tf_is_bare(of, 3 * triangle) && tf_is_bare(of, 3 * triangle + 1) &&
           tf_is_bare(of, 3 * triangle + 2);
}

bool tf_is_rim(const tf_adaptive *of, int vertex)
{
    int c = tf_first_corner(of, vertex);
    for (; c != TF_NONE; c = tf_next_corner(of, c))
        if (tf_is_bare(of, c))
            return true;
    return false;
}

//: Count triangles and neighbors
int tf_star_size(const tf_adaptive *of, int vertex)
{
    int count = 0, c = tf_first_corner(of, vertex);
    for (; c != TF_NONE; c = tf_next_corner(of, c))
        count++;
    return count;
}

static bool are_neighbors(const tf_adaptive *of, int a, int b)
{
    return tf_find_edge(of, a, b) != TF_NONE ||
           tf_find_edge(of, b, a) != TF_NONE;
}

/// Each neighbor follows the vertex in one triangle, except for one, on the
/// boundary, that only precedes it.
int tf_common_neighbors(const tf_adaptive *of, int a, int b)
{
    int count = 0, c = tf_first_corner(of, a);
    for (; c != TF_NONE; c = tf_next_corner(of, c)) {
        int before = tf_corner_before(c);
        count += are_neighbors(of, tf_vertex_at(of, tf_corner_after(c)), b);
        count += tf_is_bare(of, before) &&
                 are_neighbors(of, tf_vertex_at(of, before), b);
    }
    return count;
}

//: Link the corners of a triangle
static void link_corner(tf_adaptive *of, int corner)
{
    int *first = (int *)of->first.data + tf_vertex_at(of, corner);
    ((int *)of->next.data)[corner] = *first;
    *first = corner;
}

static void unlink_corner(tf_adaptive *of, int corner)
{
    int *link = (int *)of->first.data + tf_vertex_at(of, corner);
    while (*link != corner)
        link = (int *)of->next.data + *link;
    *link = tf_next_corner(of, corner);
}

//: Link all triangles
void tf_stars_build(tf_adaptive *of, tf_cuboid box[])
{
    int *order = of->found.data;
    of->free_triangle = TF_NONE;
    for (int v = 0; v < of->vertices; v++)
        ((int *)of->first.data)[v] = TF_NONE;
    for (int t = of->triangles - 1; t >= 0; t--) {
        for (int i = 0; i < 3; i++)
            link_corner(of, 3 * t + i);
        box[t] = tf_cuboid_of(of, 3, tf_triangle(of, t));
        order[t] = t;
    }
    tf_hierarchy_build(&of->boxes, box, order, of->triangles);
}

//: Add and remove triangles
static int take_place(tf_adaptive *of)
{
    int taken = of->free_triangle;
    if (taken == TF_NONE)
        return of->triangles++;
    of->free_triangle = tf_vertex_at(of, 3 * taken + 1);
    return taken;
}

int tf_triangle_add(tf_adaptive *of, const int vertex[3])
{
    int added = take_place(of);
    for (int i = 0; i < 3; i++) {
        ((int *)of->vertex.data)[3 * added + i] = vertex[i];
        link_corner(of, 3 * added + i);
    }
    tf_hierarchy_insert(&of->boxes, added, tf_cuboid_of(of, 3, vertex));
    return added;
}

void tf_triangle_remove(tf_adaptive *of, int triangle)
{
    int *vertex = (int *)of->vertex.data + 3 * (ptrdiff_t)triangle;
    for (int i = 0; i < 3; i++)
        unlink_corner(of, 3 * triangle + i);
    tf_hierarchy_remove(&of->boxes, triangle);
    vertex[0] = vertex[2] = TF_NONE;
    vertex[1] = of->free_triangle;
    of->free_triangle = triangle;
}
