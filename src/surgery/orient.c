//: Include what orienting needs
#include "surgery/orient.h"

#include "surgery/star.h"

#include <string.h>

//: Hold which triangles are to agree
/// Triangles that are connected are a tree: each has a link to another one with
/// a lower number, or to itself if it is the first.
typedef struct orientation {
    const tf_adaptive_surface *surface;
    tf_buffer
        link; ///< int of each triangle: twice the number of the other one,
              ///< and 1 if only one of the two must be turned
    tf_buffer excess; ///< int of each first triangle: by how many more disagree
                      ///< with it than agree
} orientation;

//: Find the first triangle of a tree
/// As a link to it; shortens the way there.
static int first_of(orientation *all, int triangle)
{
    int *link = all->link.data, differs = 0;
    while (link[triangle] / 2 != triangle) {
        link[triangle] = link[link[triangle] / 2] ^ (link[triangle] & 1);
        differs ^= link[triangle] & 1;
        triangle = link[triangle] / 2;
    }
    return 2 * triangle | differs;
}

//: Connect two triangles
/// Nothing changes if they are connected.
static void connect(orientation *all, int a, int b, bool agree)
{
    int *link = all->link.data;
    int first = first_of(all, a), second = first_of(all, b);
    int differs = (first ^ second ^ !agree) & 1;
    if (first / 2 < second / 2)
        link[second / 2] = first / 2 * 2 | differs;
    else if (first / 2 > second / 2)
        link[first / 2] = second / 2 * 2 | differs;
}

//: Find the other triangle on an edge
/// A corner of it, if the edge of this corner has just two triangles: the one at
/// which it passes the edge.
static int across(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    int other = TF_NONE, count = 0, c = tf_first_corner(surface, from);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        bool forth = tf_vertex_at(surface, tf_corner_after(c)) == to;
        bool back = tf_vertex_at(surface, tf_corner_before(c)) == to;
        if (c == corner || (!forth && !back))
            continue;
        other = forth ? c : tf_corner_before(c);
        count++;
    }
    return count == 1 ? other : TF_NONE;
}

//: Connect all triangles
/// Those that agree first: so a surface with one side keeps its seam.
static void connect_all(orientation *all)
{
    const tf_adaptive_surface *surface = all->surface;
    for (int t = 0; t < surface->triangles; t++)
        ((int *)all->link.data)[t] = 2 * t;
    for (int i = 0; i < 2; i++)
        for (int c = 0; c < 3 * surface->triangles; c++) {
            int other = across(surface, c);
            if (other == TF_NONE)
                continue;
            bool agree =
                tf_vertex_at(surface, other) != tf_vertex_at(surface, c);
            if (agree == (i == 0))
                connect(all, c / 3, other / 3, agree);
        }
}

//: Turn the fewer triangles
static void count_excess(orientation *all)
{
    int *excess = all->excess.data, count = all->surface->triangles;
    memset(excess, 0, sizeof *excess * (size_t)count);
    for (int t = 0; t < count; t++) {
        int first = first_of(all, t);
        excess[first / 2] += first & 1 ? 1 : -1;
    }
}

/// Exchanges the corners of a triangle after the first.
static void turn_triangle(tf_adaptive_surface *surface, int triangle)
{
    int *vertex = (int *)surface->vertex.data + 3 * (ptrdiff_t)triangle;
    int second = vertex[1];
    vertex[1] = vertex[2];
    vertex[2] = second;
}

static int turn_fewer(orientation *all, tf_adaptive_surface *surface)
{
    const int *excess = all->excess.data;
    int turned = 0;
    for (int t = 0; t < surface->triangles; t++) {
        int first = first_of(all, t);
        if ((first & 1) == (excess[first / 2] > 0))
            continue;
        turn_triangle(surface, t);
        turned++;
    }
    return turned;
}

//: Orient all triangles
tf_status tf_orient_triangles(tf_adaptive_surface *surface, int *turned)
{
    orientation all = {.surface = surface};
    size_t count = (size_t)surface->triangles;
    bool has_room = tf_buffer_extend(&all.link, count, sizeof(int)) &&
                    tf_buffer_extend(&all.excess, count, sizeof(int));
    if (has_room) {
        connect_all(&all);
        count_excess(&all);
        *turned = turn_fewer(&all, surface);
        if (*turned > 0)
            tf_stars_build(surface, surface->box.data);
    }
    tf_buffer_free(&all.link);
    tf_buffer_free(&all.excess);
    return has_room ? TF_OK : TF_OUT_OF_MEMORY;
}
