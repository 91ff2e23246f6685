//: Include what the origins of corners need
#include "remesh/corner_origins.h"

#include "base/require.h"
#include "linear/distance.h"
#include "remesh/measure.h"
#include "surgery/star.h"

#include <string.h>

enum {
    WATCHED = 1024 ///< triangles between two looks at the watch
};

//: Hold a divided surface
/// A surface that its sharp edges divide into regions.
typedef struct division {
    const tf_adaptive_surface *surface;
    const tf_sharp_edges *sharp;
    tf_buffer region; ///< int of each triangle
    int regions;
} division;

static int *region_at(const division *divided, int triangle)
{
    return (int *)divided->region.data + triangle;
}

/// From the vertex at a corner to the next one; NULL: it is no sharp edge.
static const tf_sharp_link *link_at(const division *divided, int corner)
{
    return tf_find_sharp_edge(
        divided->sharp, tf_vertex_at(divided->surface, corner),
        tf_vertex_at(divided->surface, tf_corner_after(corner)));
}

/// The corner where the same edge begins in its other triangle.  An edge without
/// one is on the boundary, which is sharp.
static int corner_across(const division *divided, int corner)
{
    int from = tf_vertex_at(divided->surface, corner);
    int to = tf_vertex_at(divided->surface, tf_corner_after(corner));
    int across = tf_find_edge(divided->surface, to, from);
    TF_REQUIRE(across != TF_NONE);
    return across;
}

//: Divide a surface
/// Spreads a region from a triangle on; the stack has room for all triangles.
/// False if the caller cancels.
static bool spread(division *divided, int triangle, int stack[],
                   tf_watch *watch)
{
    int count = 0, visited = 0;
    *region_at(divided, triangle) = divided->regions;
    stack[count++] = triangle;
    while (count > 0) {
        int corner = 3 * stack[--count];
        if (++visited % WATCHED == 0 && !tf_watch_done(watch, 0))
            return false;
        for (int c = corner; c < corner + 3; c++) {
            if (link_at(divided, c))
                continue;
            int next = corner_across(divided, c) / 3;
            if (*region_at(divided, next) != TF_NONE)
                continue;
            *region_at(divided, next) = divided->regions;
            stack[count++] = next;
        }
    }
    return true;
}

static tf_status divide(division *divided, tf_buffer *stack, tf_watch *watch)
{
    int triangles = divided->surface->triangles;
    if (!tf_buffer_extend(&divided->region, (size_t)triangles, sizeof(int)) ||
        !tf_buffer_extend(stack, (size_t)triangles, sizeof(int)))
        return TF_OUT_OF_MEMORY;
    for (int t = 0; t < triangles; t++)
        *region_at(divided, t) = TF_NONE;
    for (int t = 0; t < triangles; t++) {
        if (t % WATCHED == 0 && !tf_watch_done(watch, 0))
            return TF_CANCELLED;
        if (!tf_is_triangle(divided->surface, t) ||
            *region_at(divided, t) != TF_NONE)
            continue;
        if (!spread(divided, t, stack->data, watch))
            return TF_CANCELLED;
        divided->regions++;
    }
    return TF_OK;
}

//: Match the regions
/// A surface and its original.
typedef struct matching {
    division before, now;
    const tf_origin *origin; ///< of each vertex
    tf_buffer left;   ///< int of each side of sharp edges: the region of the
                      ///< original on it, or TF_NONE
    tf_buffer source; ///< int of each region: that of the original
    tf_buffer stack;  ///< memory for spreading
} matching;

static int *left_of(const matching *matched, int side)
{
    return (int *)matched->left.data + side;
}

static int *source_of(const matching *matched, int region)
{
    return (int *)matched->source.data + region;
}

/// False if the caller cancels.
static bool find_sides(const matching *matched, tf_watch *watch)
{
    const division *before = &matched->before;
    for (int i = 0; i < before->sharp->sides; i++)
        *left_of(matched, i) = TF_NONE;
    for (int c = 0; c < 3 * before->surface->triangles; c++) {
        if (c % WATCHED == 0 && !tf_watch_done(watch, 0))
            return false;
        const tf_sharp_link *link =
            tf_is_triangle(before->surface, c / 3) ? link_at(before, c) : NULL;
        if (link)
            *left_of(matched, link->side) = *region_at(before, c / 3);
    }
    return true;
}

/// A triangle of frozen vertices, which is one of the original.
static int triangle_before(const matching *matched, const int vertex[3])
{
    const tf_adaptive_surface *before = matched->before.surface;
    int v[3];
    for (int i = 0; i < 3; i++) {
        const tf_origin *origin = &matched->origin[vertex[i]];
        int k = 0;
        while (origin->barycentric[k] != 1)
            k++;
        v[i] = tf_triangle(before, origin->triangle)[k];
    }
    int c = tf_first_corner(before, v[0]);
    while (tf_vertex_at(before, tf_corner_after(c)) != v[1] ||
           tf_vertex_at(before, tf_corner_before(c)) != v[2])
        c = tf_next_corner(before, c);
    return c / 3;
}

static bool is_all_frozen(const tf_adaptive_surface *surface,
                          const int vertex[3])
{
    return tf_is_frozen_edge(surface, vertex[0], vertex[1]) &&
           tf_is_frozen(surface, vertex[2]);
}

/// What a corner tells of the region of its triangle: by a sharp edge that is not
/// frozen, and may have only two triangles; or for want of those by a vertex.
static void match_corner(const matching *matched, int corner)
{
    const division *before = &matched->before, *now = &matched->now;
    const int *v = tf_triangle(now->surface, corner / 3);
    int vertex = tf_vertex_at(now->surface, corner);
    int *source = source_of(matched, *region_at(now, corner / 3));
    const tf_sharp_link *link = link_at(now, corner);
    if (is_all_frozen(now->surface, v))
        *source = *region_at(before, triangle_before(matched, v));
    else if (link && !tf_is_frozen_edge(now->surface, vertex, link->to))
        *source = *left_of(matched, link->side);
    else if (*source == TF_NONE && !tf_is_frozen(now->surface, vertex))
        *source = *region_at(before, matched->origin[vertex].triangle);
}

/// Finds from which region of the original each region comes.  False if the
/// caller cancels.
static bool find_sources(const matching *matched, tf_watch *watch)
{
    const division *now = &matched->now;
    for (int i = 0; i < now->regions; i++)
        *source_of(matched, i) = TF_NONE;
    for (int c = 0; c < 3 * now->surface->triangles; c++) {
        if (c % WATCHED == 0 && !tf_watch_done(watch, 0))
            return false;
        match_corner(matched, c);
    }
    return true;
}

static tf_status match(matching *matched, tf_watch *watch)
{
    tf_status status = divide(&matched->before, &matched->stack, watch);
    if (status == TF_OK)
        status = divide(&matched->now, &matched->stack, watch);
    if (status != TF_OK)
        return status;
    size_t sides = (size_t)matched->before.sharp->sides;
    size_t regions = (size_t)matched->now.regions;
    if (!tf_buffer_extend(&matched->left, sides, sizeof(int)) ||
        !tf_buffer_extend(&matched->source, regions, sizeof(int)))
        return TF_OUT_OF_MEMORY;
    return find_sides(matched, watch) && find_sources(matched, watch)
               ? TF_OK
               : TF_CANCELLED;
}

//: Find the side of a corner
/// The first sharp edge from its vertex that a turn to the right around it, from
/// its triangle on, comes to: the triangle is on its left; NULL: the vertex is on
/// none.
static const tf_sharp_link *edge_before(const division *now, int corner)
{
    const tf_sharp_link *link = link_at(now, corner);
    for (int c = corner; !link; link = link_at(now, c)) {
        c = tf_corner_after(corner_across(now, c));
        if (c == corner)
            break;
    }
    return link;
}

//: Carry an origin across
/// The same point on another triangle, which has all corners with a weight.
static tf_origin carried(const tf_adaptive_surface *surface,
                         const tf_origin *origin, int triangle)
{
    tf_origin made = {.triangle = triangle};
    const int *from = tf_triangle(surface, origin->triangle);
    const int *to = tf_triangle(surface, triangle);
    for (int i = 0; i < 9; i++)
        if (to[i / 3] == from[i % 3])
            made.barycentric[i / 3] = origin->barycentric[i % 3];
    return made;
}

/// Whether a triangle has these corners.
static bool holds(const tf_adaptive_surface *surface, const tf_origin *origin,
                  int triangle)
{
    tf_origin same = carried(surface, origin, triangle);
    return same.barycentric[0] + same.barycentric[1] + same.barycentric[2] >=
           origin->barycentric[0] + origin->barycentric[1] +
               origin->barycentric[2];
}

/// The triangle with an origin, on a sharp edge, that has this side of it on its
/// left, or TF_NONE.
static int triangle_beside(const division *before, const tf_origin *origin,
                           int side)
{
    const tf_adaptive_surface *surface = before->surface;
    for (int i = 0; i < 3; i++) {
        int c =
            tf_first_corner(surface, tf_triangle(surface, origin->triangle)[i]);
        for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
            const tf_sharp_link *link = link_at(before, c);
            if (link && link->side == side && holds(surface, origin, c / 3))
                return c / 3;
        }
    }
    return TF_NONE;
}

//: Find the nearest point of a region
/// For the few vertices that are not where their regions were, by so little as
/// sharp edges have become straighter.
static tf_origin nearest_in(const division *before, int region, tf_vector point)
{
    const tf_adaptive_surface *surface = before->surface;
    tf_origin best = {0};
    double least = INFINITY;
    for (int t = 0; t < surface->triangles; t++) {
        if (*region_at(before, t) != region)
            continue;
        tf_shape shape = tf_shape_of(surface, t);
        tf_vector x[4] = {point};
        memcpy(x + 1, shape.corner, sizeof shape.corner);
        tf_point_pair pair = tf_nearest_points(1, 3, x);
        if (!(pair.distance < least) && isfinite(least))
            continue;
        least = pair.distance;
        best.triangle = t;
        memcpy(best.barycentric, pair.weight + 1, sizeof best.barycentric);
    }
    return best;
}

//: Find the origins of corners
static tf_origin origin_of(const matching *matched, int corner)
{
    const division *before = &matched->before, *now = &matched->now;
    int vertex = tf_vertex_at(now->surface, corner);
    int region = *source_of(matched, *region_at(now, corner / 3));
    const tf_origin *origin = &matched->origin[vertex];
    const tf_sharp_link *link = edge_before(now, corner);
    int triangle =
        link ? triangle_beside(before, origin, link->side) : origin->triangle;
    return triangle != TF_NONE && *region_at(before, triangle) == region
               ? carried(before->surface, origin, triangle)
               : nearest_in(before, region,
                            tf_position_of(now->surface, vertex));
}

static tf_status find_origins(const matching *matched, tf_buffer *origin,
                              tf_watch *watch)
{
    int corners = 3 * matched->now.surface->triangles;
    if (!tf_buffer_extend(origin, (size_t)corners, sizeof(tf_origin)))
        return TF_OUT_OF_MEMORY;
    for (int c = 0; c < corners; c++) {
        if (c % WATCHED == 0 && !tf_watch_done(watch, 0))
            return TF_CANCELLED;
        ((tf_origin *)origin->data)[c] = origin_of(matched, c);
    }
    return TF_OK;
}

tf_status tf_corner_origins_find(const tf_remesher *remesher, tf_buffer *origin)
{
    matching matched = {
        .before = {.surface = remesher->original.surface,
                   .sharp = &remesher->sharp_before},
        .now = {.surface = remesher->surface, .sharp = &remesher->sharp},
        .origin = remesher->trace.origin.data};
    tf_watch *watch = remesher->surface->watch;
    tf_status status = match(&matched, watch);
    if (status == TF_OK)
        status = find_origins(&matched, origin, watch);
    tf_buffer_free(&matched.before.region);
    tf_buffer_free(&matched.now.region);
    tf_buffer_free(&matched.left);
    tf_buffer_free(&matched.source);
    tf_buffer_free(&matched.stack);
    return status;
}
