//: Include what sharp edges need
#include "remesh/sharp_edges.h"

#include "remesh/measure.h"
#include "surgery/star.h"

#include <string.h>

//: Link vertices by sharp edges
static int *first_of(const tf_sharp_edges *all, int vertex)
{
    return (int *)all->first.data + vertex;
}

static tf_sharp_link *link_of(const tf_sharp_edges *all, int link)
{
    return (tf_sharp_link *)all->link.data + link;
}

static bool *held_at(const tf_sharp_edges *all, int vertex)
{
    return (bool *)all->held.data + vertex;
}

const tf_sharp_link *tf_find_sharp_edge(const tf_sharp_edges *all, int a, int b)
{
    int link = *first_of(all, a);
    while (link != TF_NONE && link_of(all, link)->to != b)
        link = link_of(all, link)->next;
    return link == TF_NONE ? NULL : link_of(all, link);
}

//: Make room for sharp edges
bool tf_sharp_edges_extend(tf_sharp_edges *all, int vertices)
{
    if (vertices <= all->vertices)
        return true;
    if (!tf_buffer_extend(&all->first, (size_t)vertices, sizeof(int)) ||
        !tf_buffer_extend(&all->held, (size_t)vertices, sizeof(bool)))
        return false;
    for (int v = all->vertices; v < vertices; v++) {
        *first_of(all, v) = TF_NONE;
        *held_at(all, v) = false;
    }
    all->vertices = vertices;
    return true;
}

/// All vertices lose their sharp edges.
static bool begin_sharp_edges(tf_sharp_edges *all, int vertices)
{
    all->vertices = all->links = all->sides = 0;
    all->unused = TF_NONE;
    return tf_sharp_edges_extend(all, vertices);
}

void tf_sharp_edges_free(tf_sharp_edges *all)
{
    tf_buffer_free(&all->first);
    tf_buffer_free(&all->link);
    tf_buffer_free(&all->held);
}

//: Add a sharp edge
/// For which there is room.
static void add_link(tf_sharp_edges *all, int from, int to, double length,
                     int side)
{
    int link = all->unused;
    if (link == TF_NONE)
        link = all->links++;
    else
        all->unused = link_of(all, link)->next;
    *link_of(all, link) =
        (tf_sharp_link){to, *first_of(all, from), length, side};
    *first_of(all, from) = link;
}

/// By its sides from a to b, and back.
static bool add_edge(tf_sharp_edges *all, int a, int b, double length,
                     const int side[2])
{
    if (!tf_buffer_extend(&all->link, (size_t)all->links + 2,
                          sizeof(tf_sharp_link)))
        return false;
    add_link(all, a, b, length, side[0]);
    add_link(all, b, a, length, side[1]);
    return true;
}

bool tf_sharp_edges_add(tf_sharp_edges *all, int a, int b, double length)
{
    static const int no_sides[] = {TF_NONE, TF_NONE};
    return tf_find_sharp_edge(all, a, b) ||
           add_edge(all, a, b, length, no_sides);
}

//: Remove a sharp edge
static void remove_link(tf_sharp_edges *all, int from, int to)
{
    int *place = first_of(all, from);
    while (link_of(all, *place)->to != to)
        place = &link_of(all, *place)->next;
    int link = *place;
    *place = link_of(all, link)->next;
    link_of(all, link)->next = all->unused;
    all->unused = link;
}

static void remove_edge(tf_sharp_edges *all, int a, int b)
{
    remove_link(all, a, b);
    remove_link(all, b, a);
}

//: Hand on sharp edges
bool tf_sharp_edges_split(tf_sharp_edges *all, int a, int b, int vertex)
{
    const tf_sharp_link *forth = tf_find_sharp_edge(all, a, b);
    double half = forth->length / 2;
    int side[] = {forth->side, tf_find_sharp_edge(all, b, a)->side};
    remove_edge(all, a, b);
    return add_edge(all, a, vertex, half, side) &&
           add_edge(all, vertex, b, half, side);
}

/// Each sharp edge that is removed makes room for the one that takes its place.
void tf_sharp_edges_collapse(tf_sharp_edges *all, int from, int to)
{
    const tf_sharp_link *along = tf_find_sharp_edge(all, from, to);
    double length = along ? along->length : 0;
    while (*first_of(all, from) != TF_NONE) {
        tf_sharp_link next = *link_of(all, *first_of(all, from));
        int back = tf_find_sharp_edge(all, next.to, from)->side;
        remove_edge(all, from, next.to);
        if (next.to == to)
            continue;
        add_link(all, to, next.to, length + next.length, next.side);
        add_link(all, next.to, to, length + next.length, back);
    }
}

//: Copy sharp edges
static bool copy(tf_buffer *to, const tf_buffer *from, int count, size_t size)
{
    if (!tf_buffer_extend(to, (size_t)count, size))
        return false;
    if (count > 0)
        memcpy(to->data, from->data, (size_t)count * size);
    return true;
}

bool tf_sharp_edges_copy(tf_sharp_edges *all, const tf_sharp_edges *from)
{
    all->vertices = from->vertices;
    all->links = from->links;
    all->unused = from->unused;
    all->sides = from->sides;
    return copy(&all->first, &from->first, all->vertices, sizeof(int)) &&
           copy(&all->held, &from->held, all->vertices, sizeof(bool)) &&
           copy(&all->link, &from->link, all->links, sizeof(tf_sharp_link));
}

//: Close the gaps of sharp edges
/// A vertex that is gone has handed on its sharp edges.
void tf_sharp_edges_compact(tf_sharp_edges *all, const int map[])
{
    int count = 0;
    for (int v = 0; v < all->vertices; v++) {
        if (map[v] == TF_NONE)
            continue;
        int link = *first_of(all, v);
        *first_of(all, count) = link;
        *held_at(all, count++) = *held_at(all, v);
        for (; link != TF_NONE; link = link_of(all, link)->next)
            link_of(all, link)->to = map[link_of(all, link)->to];
    }
    all->vertices = count;
}

//: Measure how a surface turns
/// The triangles on an edge inside the surface.
static void find_pair(const tf_adaptive_surface *surface, int corner,
                      tf_shape pair[2])
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    pair[0] = tf_shape_of(surface, corner / 3);
    pair[1] = tf_shape_of(surface, tf_find_edge(surface, to, from) / 3);
}

double tf_turn_at(const tf_adaptive_surface *surface, int corner)
{
    tf_shape pair[2];
    find_pair(surface, corner, pair);
    return tf_vector_length(
        tf_vector_difference(tf_vector_unit(tf_shape_normal(&pair[0])),
                             tf_vector_unit(tf_shape_normal(&pair[1]))));
}

double tf_height_at(const tf_adaptive_surface *surface, int corner)
{
    tf_shape pair[2];
    find_pair(surface, corner, pair);
    int after = tf_corner_after(corner);
    return (tf_vector_length(tf_shape_normal(&pair[0])) +
            tf_vector_length(tf_shape_normal(&pair[1]))) /
           (2 * tf_length_of(surface, tf_vertex_at(surface, corner),
                             tf_vertex_at(surface, after)));
}

//: Recognize a sharp edge
/// Edges that are left alone are sharp, since they may have any number of
/// triangles.
static bool is_sharp(const tf_adaptive_surface *surface, int corner,
                     const tf_sharpness *sharpness)
{
    int end[] = {tf_vertex_at(surface, corner),
                 tf_vertex_at(surface, tf_corner_after(corner))};
    if (tf_is_boundary_edge(surface, corner) ||
        tf_is_frozen_edge(surface, end[0], end[1]))
        return true;
    tf_shape pair[2];
    find_pair(surface, corner, pair);
    return !tf_normals_agree(tf_shape_normal(&pair[0]),
                             tf_shape_normal(&pair[1]), sharpness->cosine) ||
           tf_turn_at(surface, corner) * tf_height_at(surface, corner) >
               1.5 * sharpness->depth;
}

//: Recognize a corner
/// Whether a vertex is not between two sharp edges that go on nearly straight.
static bool is_corner(const tf_sharp_edges *all,
                      const tf_adaptive_surface *surface, int vertex)
{
    tf_vector sum = {{0}}, at = tf_position_of(surface, vertex);
    int count = 0, link = *first_of(all, vertex);
    for (; link != TF_NONE; link = link_of(all, link)->next, count++) {
        tf_vector along = tf_vector_difference(
            tf_position_of(surface, link_of(all, link)->to), at);
        sum = tf_vector_sum(sum, 1 / tf_vector_length(along), along);
    }
    // Two unit vectors in nearly opposite directions cancel.
    return count > 0 && !(count == 2 && tf_vector_length(sum) < 0.5);
}

//: Number the sides of sharp edges
enum {
    WATCHED = 1024 ///< corners or vertices between two looks at the watch
};

/// The link with which a line of sharp edges goes on from the end of another
/// one; NULL: it ends there.
static tf_sharp_link *link_after(const tf_sharp_edges *all, int from, int end)
{
    if (*held_at(all, end))
        return NULL;
    tf_sharp_link *next = link_of(all, *first_of(all, end));
    return next->to == from ? link_of(all, next->next) : next;
}

/// Gives a new number to the side of a line from a link on.
static void number_side(tf_sharp_edges *all, int from, tf_sharp_link *link)
{
    if (link->side != TF_NONE)
        return;
    for (int end; link && link->side == TF_NONE; from = end) {
        link->side = all->sides;
        end = link->to;
        link = link_after(all, from, end);
    }
    all->sides++;
}

/// Lines that end somewhere are numbered from there on, and then the closed ones.
static tf_status number_sides(tf_sharp_edges *all, tf_watch *watch)
{
    for (int pass = 0; pass < 2; pass++)
        for (int v = 0; v < all->vertices; v++) {
            if (v % WATCHED == 0 && !tf_watch_done(watch, 0))
                return TF_CANCELLED;
            int link =
                pass == 1 || *held_at(all, v) ? *first_of(all, v) : TF_NONE;
            for (; link != TF_NONE; link = link_of(all, link)->next)
                number_side(all, v, link_of(all, link));
        }
    return TF_OK;
}

//: Find the sharp edges of a surface
const tf_sharpness tf_sharp_boundary = {.cosine = -2, .depth = INFINITY};

static tf_status add_sharp(tf_sharp_edges *all,
                           const tf_adaptive_surface *surface,
                           const tf_sharpness *sharpness, tf_watch *watch)
{
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (c % WATCHED == 0 && !tf_watch_done(watch, 0))
            return TF_CANCELLED;
        if (!tf_is_triangle(surface, c / 3) || !is_sharp(surface, c, sharpness))
            continue;
        int a = tf_vertex_at(surface, c);
        int b = tf_vertex_at(surface, tf_corner_after(c));
        if (!tf_sharp_edges_add(all, a, b, tf_length_of(surface, a, b)))
            return TF_OUT_OF_MEMORY;
    }
    return TF_OK;
}

static bool add_kept(tf_sharp_edges *all, const tf_adaptive_surface *surface,
                     const tf_sharpness *sharpness)
{
    for (int i = 0; i < sharpness->keeps; i++) {
        const int *v = sharpness->keep + 2 * (ptrdiff_t)i;
        double length = tf_length_of(surface, v[0], v[1]);
        if (v[0] != v[1] && !tf_sharp_edges_add(all, v[0], v[1], length))
            return false;
    }
    return true;
}

static tf_status hold_corners(tf_sharp_edges *all,
                              const tf_adaptive_surface *surface,
                              const tf_sharpness *sharpness, tf_watch *watch)
{
    for (int v = 0; v < surface->vertices; v++) {
        if (v % WATCHED == 0 && !tf_watch_done(watch, 0))
            return TF_CANCELLED;
        *held_at(all, v) =
            is_corner(all, surface, v) || tf_is_frozen(surface, v);
    }
    for (int i = 0; i < sharpness->keeps; i++) {
        const int *v = sharpness->keep + 2 * (ptrdiff_t)i;
        if (v[0] == v[1])
            *held_at(all, v[0]) = true;
    }
    return TF_OK;
}

tf_status tf_sharp_edges_find(tf_sharp_edges *all,
                              const tf_adaptive_surface *surface,
                              const tf_sharpness *sharpness, tf_watch *watch)
{
    if (!begin_sharp_edges(all, surface->vertices))
        return TF_OUT_OF_MEMORY;
    tf_status status = add_sharp(all, surface, sharpness, watch);
    if (status == TF_OK && !add_kept(all, surface, sharpness))
        status = TF_OUT_OF_MEMORY;
    if (status == TF_OK)
        status = hold_corners(all, surface, sharpness, watch);
    return status == TF_OK ? number_sides(all, watch) : status;
}

//: Find the freedom of a vertex
tf_freedom tf_freedom_of(const tf_sharp_edges *all, int vertex)
{
    if (*held_at(all, vertex))
        return TF_HELD;
    return *first_of(all, vertex) == TF_NONE ? TF_FREE : TF_ALONG_SHARP_EDGE;
}

//: Find the sharp edges along which a vertex moves
tf_sharp_pair tf_sharp_edges_along(const tf_sharp_edges *all, int vertex)
{
    const tf_sharp_link *first = link_of(all, *first_of(all, vertex));
    return (tf_sharp_pair){{first, link_of(all, first->next)}};
}

/// Both links of an edge have its length.
static void set_length(tf_sharp_edges *all, int a, int b, double length)
{
    for (int i = 0; i < 2; i++) {
        int link = *first_of(all, i ? a : b);
        while (link_of(all, link)->to != (i ? b : a))
            link = link_of(all, link)->next;
        link_of(all, link)->length = length;
    }
}

void tf_sharp_edges_slide(tf_sharp_edges *all,
                          const tf_adaptive_surface *surface, int vertex)
{
    tf_sharp_pair pair = tf_sharp_edges_along(all, vertex);
    int end[] = {pair.link[0]->to, pair.link[1]->to};
    double whole = pair.link[0]->length + pair.link[1]->length;
    double length[] = {tf_length_of(surface, vertex, end[0]),
                       tf_length_of(surface, vertex, end[1])};
    for (int i = 0; i < 2; i++)
        set_length(all, vertex, end[i],
                   whole * length[i] / (length[0] + length[1]));
}

//: Let the freer vertex go
/// Whether the sharp edge that two others become is a new one and long enough,
/// if a vertex between these two goes to an end of one.
static bool keeps_length(const tf_adaptive_surface *surface,
                         const tf_sharp_edges *all, int from, int to,
                         double least)
{
    double length = tf_find_sharp_edge(all, from, to)->length;
    const tf_sharp_link *next = link_of(all, *first_of(all, from));
    if (next->to == to)
        next = link_of(all, next->next);
    return !tf_find_sharp_edge(all, to, next->to) &&
           tf_length_of(surface, to, next->to) >=
               least * (length + next->length);
}

bool tf_collapse_freer(const tf_adaptive_surface *surface,
                       const tf_sharp_edges *all, int corner, double least,
                       tf_edge_collapse *collapse)
{
    const int end[] = {tf_vertex_at(surface, corner),
                       tf_vertex_at(surface, tf_corner_after(corner))};
    const tf_freedom freedom[] = {tf_freedom_of(all, end[0]),
                                  tf_freedom_of(all, end[1])};
    int i = freedom[1] > freedom[0], from = end[i], to = end[1 - i];
    *collapse = (tf_edge_collapse){from, to, tf_position_of(surface, to)};
    return freedom[i] == TF_FREE ||
           (freedom[i] == TF_ALONG_SHARP_EDGE &&
            tf_find_sharp_edge(all, from, to) &&
            keeps_length(surface, all, from, to, least));
}
