//: Include what traces need
#include "remesh/trace.h"

#include "linear/distance.h"
#include "remesh/measure.h"
#include "surgery/star.h"

#include <string.h>

//: Look at origins
static tf_origin *origins_of(const tf_trace *trace)
{
    return trace->origin.data;
}

static tf_origin origin_of_corner(int corner)
{
    tf_origin origin = {.triangle = corner / 3};
    origin.barycentric[corner % 3] = 1;
    return origin;
}

//: Begin with all vertices at corners
bool tf_trace_begin(tf_trace *trace, const tf_original *original,
                    const tf_sharp_edges *sharp)
{
    const tf_adaptive_surface *surface = original->surface;
    size_t vertices = (size_t)surface->vertices;
    size_t elements = vertices + (size_t)surface->triangles;
    if (!tf_buffer_extend(&trace->origin, vertices, sizeof(tf_origin)) ||
        !tf_buffer_extend(&trace->visited, elements, sizeof(int)) ||
        !tf_buffer_extend(&trace->reached, vertices, sizeof(int)))
        return false;
    if (elements > 0)
        memset(trace->visited.data, 0, elements * sizeof(int));
    trace->original = original;
    trace->sharp = sharp;
    trace->search = 0;
    for (int v = 0; v < surface->vertices; v++) {
        int corner = tf_first_corner(surface, v);
        if (corner != TF_NONE)
            origins_of(trace)[v] = origin_of_corner(corner);
    }
    return true;
}

//: Free a trace
void tf_trace_free(tf_trace *trace)
{
    tf_buffer_free(&trace->origin);
    tf_buffer_free(&trace->visited);
    tf_buffer_free(&trace->reached);
}

//: Hold a search
/// An origin, and its distance from the vertex.
typedef struct candidate {
    double distance;
    tf_origin origin;
} candidate;

/// A search along the original for where a vertex comes from.  It begins where
/// its neighbors come from, and goes on while it is near the vertex: so it stays
/// on the sheet.
typedef struct trace_search {
    tf_trace *trace;
    const tf_adaptive_surface *original;
    tf_watch *watch;
    tf_vector point;   ///< where the vertex is
    tf_vector normal;  ///< that of the surface there
    double radius;     ///< how far from there the search goes on
    int reached;       ///< how many vertices of the original
    candidate nearest; ///< of all
    candidate facing;  ///< nearest of those that face to where the surface does
} trace_search;

//: Reach along the original
/// Whether a search comes to an element for the first time.
static bool visit(const trace_search *search, int element)
{
    int *last = (int *)search->trace->visited.data + element;
    bool first = *last != search->trace->search;
    *last = search->trace->search;
    return first;
}

static void reach(trace_search *search, int vertex)
{
    if (visit(search, vertex))
        ((int *)search->trace->reached.data)[search->reached++] = vertex;
}

static void keep_origin(candidate *best, double distance, tf_origin origin)
{
    if (distance < best->distance)
        *best = (candidate){distance, origin};
}

//: Search a triangle
static void search_triangle(trace_search *search, int triangle)
{
    if (!visit(search, search->original->vertices + triangle))
        return;
    tf_shape shape = tf_shape_of(search->original, triangle);
    tf_vector x[4] = {search->point};
    memcpy(x + 1, shape.corner, sizeof shape.corner);
    tf_point_pair nearest = tf_nearest_points(1, 3, x);
    tf_origin origin = {.triangle = triangle};
    memcpy(origin.barycentric, nearest.weight + 1, sizeof origin.barycentric);
    keep_origin(&search->nearest, nearest.distance, origin);
    if (tf_vector_dot(tf_shape_normal(&shape), search->normal) > 0)
        keep_origin(&search->facing, nearest.distance, origin);
    for (int i = 0; i < 3 && nearest.distance <= search->radius; i++)
        reach(search, tf_vertex_at(search->original, 3 * triangle + i));
}

static void search_star(trace_search *search, int vertex)
{
    int c = tf_first_corner(search->original, vertex);
    for (; c != TF_NONE; c = tf_next_corner(search->original, c))
        search_triangle(search, c / 3);
}

//: Search a sharp edge
static void search_edge(trace_search *search, int corner)
{
    int after = tf_corner_after(corner);
    int end[] = {tf_vertex_at(search->original, corner),
                 tf_vertex_at(search->original, after)};
    tf_vector x[] = {search->point, tf_position_of(search->original, end[0]),
                     tf_position_of(search->original, end[1])};
    tf_point_pair nearest = tf_nearest_points(1, 2, x);
    tf_origin origin = {.triangle = corner / 3};
    origin.barycentric[corner % 3] = nearest.weight[1];
    origin.barycentric[after % 3] = nearest.weight[2];
    keep_origin(&search->nearest, nearest.distance, origin);
    for (int i = 0; i < 2 && nearest.distance <= search->radius; i++)
        reach(search, end[i]);
}

/// Each edge begins at the vertex in one triangle, or, on the boundary, may end
/// there.
static void search_sharp_edges(trace_search *search, int vertex)
{
    const tf_sharp_edges *sharp = search->trace->sharp;
    int c = tf_first_corner(search->original, vertex);
    for (; c != TF_NONE; c = tf_next_corner(search->original, c)) {
        int after = tf_vertex_at(search->original, tf_corner_after(c));
        int before = tf_corner_before(c);
        if (tf_find_sharp_edge(sharp, vertex, after))
            search_edge(search, c);
        if (tf_is_boundary_edge(search->original, before))
            search_edge(search, before);
    }
}

//: Begin a search
static tf_vector point_of(const trace_search *search, const tf_origin *origin)
{
    tf_shape shape = tf_shape_of(search->original, origin->triangle);
    tf_vector point = {{0}};
    for (int i = 0; i < 3; i++)
        point = tf_vector_sum(point, origin->barycentric[i], shape.corner[i]);
    return point;
}

/// Reaches the corners that an origin is made of.
static void begin_search(trace_search *search, const int from[2])
{
    search->nearest.distance = search->facing.distance = INFINITY;
    search->reached = 0;
    search->trace->search++;
    for (int i = 0; i < 6; i++) {
        const tf_origin *origin = &origins_of(search->trace)[from[i / 3]];
        if (origin->barycentric[i % 3] > 0)
            reach(search,
                  tf_vertex_at(search->original, 3 * origin->triangle + i % 3));
    }
}

//: Search along the original
enum {
    WATCHED = 128 ///< vertices between two looks at the watch
};

static void run_search(trace_search *search, const int from[2],
                       void step(trace_search *search, int vertex))
{
    begin_search(search, from);
    const int *reached = search->trace->reached.data;
    for (int i = 0; i < search->reached; i++) {
        step(search, reached[i]);
        if (i % WATCHED == WATCHED - 1 && !tf_watch_done(search->watch, 0))
            return;
    }
}

/// How far from the vertex its neighbors come from, and half as much more.
static double radius_of(const trace_search *search, const int from[2])
{
    double radius = 0;
    for (int i = 0; i < 2; i++) {
        tf_vector point = point_of(search, &origins_of(search->trace)[from[i]]);
        tf_vector way = tf_vector_difference(point, search->point);
        radius = fmax(radius, 1.5 * tf_vector_length(way));
    }
    return radius;
}

//: Trace a vertex
static tf_vector normal_of_star(const tf_adaptive_surface *surface, int vertex)
{
    tf_vector sum = {{0}};
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        sum = tf_vector_sum(sum, 1, tf_shape_normal(&shape));
    }
    return sum;
}

/// Where lengths overflow, a vertex comes from where its neighbor does.  Of two
/// sheets whose distance is such a part of the radius, the one that faces to
/// where the surface does is the right one.
static const double same_place = 1e-6;

static tf_origin find_origin(trace_search *search, const tf_placement *placed)
{
    search->nearest.origin = search->facing.origin =
        origins_of(search->trace)[placed->from[0]];
    if (placed->sharp) {
        run_search(search, placed->from, search_sharp_edges);
        if (search->nearest.distance <= search->radius / 3)
            return search->nearest.origin;
    }
    run_search(search, placed->from, search_star);
    double most = search->nearest.distance + same_place * search->radius;
    return search->facing.distance <= most ? search->facing.origin
                                           : search->nearest.origin;
}

//: Find a point of a sharp edge
bool tf_trace_sharp_point(tf_trace *trace, const tf_adaptive_surface *surface,
                          const int between[2], tf_vector *point)
{
    if (!tf_trace_goes(trace))
        return false;
    trace_search search = {.trace = trace,
                           .original = trace->original->surface,
                           .watch = surface->watch,
                           .point = *point};
    search.radius = radius_of(&search, between);
    run_search(&search, between, search_sharp_edges);
    if (!(search.nearest.distance <= search.radius / 3))
        return false;
    *point = point_of(&search, &search.nearest.origin);
    return true;
}

//: Recognize the nearest point of all
static bool shares_vertex(const tf_adaptive_surface *surface, int a, int b)
{
    const int *v = tf_triangle(surface, a), *w = tf_triangle(surface, b);
    for (int i = 0; i < 9; i++)
        if (v[i / 3] == w[i % 3])
            return true;
    return false;
}

/// Whether the point to which a vertex was projected is surely on its sheet: on
/// a triangle at one where a neighbor comes from, that faces as the surface
/// does.
static bool is_at_hand(const trace_search *search, const tf_placement *placed)
{
    const tf_projection *projection = placed->projection;
    int triangle = projection->origin.triangle;
    if (placed->sharp || !isfinite(projection->distance) ||
        !tf_vector_equals(projection->point, search->point))
        return false;
    tf_shape shape = tf_shape_of(search->original, triangle);
    if (!(tf_vector_dot(tf_shape_normal(&shape), search->normal) > 0))
        return false;
    for (int i = 0; i < 2; i++) {
        int from = origins_of(search->trace)[placed->from[i]].triangle;
        if (shares_vertex(search->original, triangle, from))
            return true;
    }
    return false;
}

//: Trace a placement
bool tf_trace_place(tf_trace *trace, const tf_adaptive_surface *surface,
                    const tf_placement *placed)
{
    if (!tf_trace_goes(trace))
        return true;
    if (!tf_buffer_extend(&trace->origin, (size_t)surface->vertices,
                          sizeof(tf_origin)))
        return false;
    trace_search search = {.trace = trace,
                           .original = trace->original->surface,
                           .watch = surface->watch,
                           .point = tf_position_of(surface, placed->vertex),
                           .normal = normal_of_star(surface, placed->vertex)};
    search.radius = radius_of(&search, placed->from);
    origins_of(trace)[placed->vertex] = is_at_hand(&search, placed)
                                            ? placed->projection->origin
                                            : find_origin(&search, placed);
    return true;
}

//: Close the gaps of a trace
void tf_trace_compact(tf_trace *trace, int vertices, const int map[])
{
    tf_origin *origin = origins_of(trace);
    for (int v = 0; v < vertices; v++)
        if (map[v] != TF_NONE)
            origin[map[v]] = origin[v];
}
