//: Include what reaching needs
#include "remesh/reach.h"

#include "linear/distance.h"

#include <string.h>

//: Hold a piece of a triangle
enum {
    MOST_CUTS = 24,                   ///< one inside the other
    MOST_CORNERS = 3 + 2 * MOST_CUTS, ///< a cut adds two at most
    MOST_PIECES = 20000               ///< of a triangle
};

/// A convex piece of a triangle.
typedef struct piece {
    int corners;
    tf_vector corner[MOST_CORNERS];
} piece;

typedef struct reach_search {
    tf_original *original;
    double fine, enough;
    tf_watch *watch;
    int pieces; ///< so far
    tf_reach found;
} reach_search;

//: Cut a piece in two
/// A plane: its points x have (x - at) . out = 0.
typedef struct cut_plane {
    tf_vector at, out;
} cut_plane;

static double beyond(const cut_plane *plane, tf_vector x)
{
    return tf_vector_dot(tf_vector_difference(x, plane->at), plane->out);
}

static void add_corner(piece *to, tf_vector corner)
{
    to->corner[to->corners++] = corner;
}

/// The parts on both sides of a plane.  False if one of them is empty.  A plane
/// cuts two sides of a convex piece; if rounding has made a dent, the others are
/// as good as on the plane.
static bool cut(const piece *whole, const cut_plane *plane, piece part[2])
{
    part[0].corners = part[1].corners = 0;
    bool on[2] = {false, false};
    int sides = 0;
    for (int i = 0; i < whole->corners; i++) {
        tf_vector a = whole->corner[i];
        tf_vector b = whole->corner[(i + 1) % whole->corners];
        double from = beyond(plane, a), to = beyond(plane, b);
        on[from > 0] = on[from > 0] || from != 0;
        if (from <= 0)
            add_corner(&part[0], a);
        if (from >= 0)
            add_corner(&part[1], a);
        if (((from < 0 && to > 0) || (from > 0 && to < 0)) && sides++ < 2) {
            tf_vector way = tf_vector_difference(b, a);
            tf_vector between = tf_vector_sum(a, from / (from - to), way);
            add_corner(&part[0], between);
            add_corner(&part[1], between);
        }
    }
    return on[0] && on[1];
}

//: Find where a piece is cut
/// Along an edge of the triangle below its middle: that beyond which one of its
/// corners is farthest out.  False if no corner is beyond any edge.
static bool find_edge(const piece *whole, const tf_shape *below,
                      cut_plane *plane)
{
    tf_vector normal = tf_shape_normal(below);
    double farthest = 0;
    for (int i = 0; i < 3; i++) {
        tf_vector along =
            tf_vector_difference(below->corner[(i + 1) % 3], below->corner[i]);
        tf_vector out = tf_vector_cross(along, normal);
        cut_plane edge = {below->corner[i],
                          tf_vector_scaled(1 / tf_vector_length(out), out)};
        for (int k = 0; k < whole->corners; k++) {
            double far = beyond(&edge, whole->corner[k]);
            if (far > farthest) {
                farthest = far;
                *plane = edge;
            }
        }
    }
    return farthest > 0;
}

/// In the middle, across the way to a corner.
static cut_plane across(tf_vector middle, tf_vector corner)
{
    return (cut_plane){middle, tf_vector_difference(corner, middle)};
}

//: Enclose the reach of a piece
/// The distance of a corner from a triangle.  That is a convex function of the
/// point, so that no point of a piece is farther than all of its corners.
static double distance_from(const tf_shape *triangle, tf_vector point)
{
    tf_vector x[4] = {point};
    memcpy(x + 1, triangle->corner, sizeof triangle->corner);
    return tf_nearest_points(1, 3, x).distance;
}

static tf_vector middle_of(const piece *whole)
{
    tf_vector middle = {{0}};
    for (int i = 0; i < whole->corners; i++)
        middle = tf_vector_sum(middle, 1.0 / whole->corners, whole->corner[i]);
    return middle;
}

/// Whether nothing is gained by cutting on.
static bool is_enclosed(const reach_search *search, double most, int cuts)
{
    const tf_reach *found = &search->found;
    return most <= fmax(found->least * 1.01, found->least + search->fine) ||
           most <= fmax(found->most, search->enough) || cuts == MOST_CUTS ||
           search->pieces >= MOST_PIECES;
}

/// The corner of a piece that is farthest from a triangle.
static tf_vector find_farthest(const piece *whole, const tf_shape *triangle,
                               double *most)
{
    int farthest = 0;
    *most = 0;
    for (int i = 0; i < whole->corners; i++) {
        double far = distance_from(triangle, whole->corner[i]);
        if (far > *most) {
            *most = far;
            farthest = i;
        }
    }
    return whole->corner[farthest];
}

/// Cuts a piece along an edge of the triangle below its middle, or in its
/// middle.  False if rounding leaves nothing to cut.
static bool divide(const piece *whole, const tf_shape *below, tf_vector middle,
                   tf_vector farthest, piece part[2])
{
    cut_plane plane;
    if (find_edge(whole, below, &plane) && cut(whole, &plane, part))
        return true;
    plane = across(middle, farthest);
    return cut(whole, &plane, part);
}

/// The corners of a triangle tell how far it reaches at least.  Most triangles
/// are enclosed without them.
static void look_at_corners(reach_search *search, const piece *whole)
{
    for (int i = 0; i < whole->corners; i++) {
        double far =
            tf_original_project(search->original, whole->corner[i]).distance;
        search->found.least = fmax(search->found.least, far);
    }
}

enum {
    WATCHED = 16 ///< pieces, or triangles, between two looks at the watch
};

static void enclose(reach_search *search, const piece *whole, int cuts)
{
    if (search->pieces % WATCHED == WATCHED - 1 &&
        !tf_watch_done(search->watch, 0))
        return;
    tf_vector middle = middle_of(whole);
    tf_projection below = tf_original_project(search->original, middle);
    search->found.least = fmax(search->found.least, below.distance);
    if (!isfinite(below.distance))
        return;
    tf_shape shape =
        tf_shape_of(search->original->surface, below.origin.triangle);
    double most;
    tf_vector farthest = find_farthest(whole, &shape, &most);
    search->pieces++;
    if (cuts == 0 && !is_enclosed(search, most, cuts))
        look_at_corners(search, whole);
    piece part[2];
    if (is_enclosed(search, most, cuts) ||
        !divide(whole, &shape, middle, farthest, part)) {
        search->found.most = fmax(search->found.most, most);
        return;
    }
    enclose(search, &part[0], cuts + 1);
    enclose(search, &part[1], cuts + 1);
}

//: Enclose the reach of a triangle
static tf_reach reach_of(reach_search *search, const tf_shape *triangle)
{
    piece whole = {.corners = 3};
    memcpy(whole.corner, triangle->corner, sizeof triangle->corner);
    search->pieces = 0;
    search->found = (tf_reach){0};
    enclose(search, &whole, 0);
    search->found.most = fmax(search->found.most, search->found.least);
    return search->found;
}

tf_reach tf_triangle_reach(tf_original *original, const tf_shape *triangle,
                           double fine, tf_watch *watch)
{
    reach_search search = {.original = original, .fine = fine, .watch = watch};
    return reach_of(&search, triangle);
}

//: Enclose the reach of a surface
/// What no triangle needs to be told apart from, when only the greatest of all
/// is wanted.
static double known_of(const tf_reach *all, double fine)
{
    return fmax(all->most, fmax(all->least * 1.01, all->least + fine));
}

tf_reach tf_surface_reach(tf_original *original,
                          const tf_adaptive_surface *surface, double fine,
                          tf_reach_each *each, tf_watch *watch)
{
    tf_reach all = {0};
    reach_search search = {.original = original, .fine = fine, .watch = watch};
    for (int t = 0; t < surface->triangles; t++) {
        if (t % WATCHED == 0 && !tf_watch_done(watch, WATCHED))
            return all;
        if (!tf_is_triangle(surface, t))
            continue;
        tf_shape shape = tf_shape_of(surface, t);
        search.enough = each ? each->enough : known_of(&all, fine);
        tf_reach own = reach_of(&search, &shape);
        all.least = fmax(all.least, own.least);
        all.most = fmax(all.most, own.most);
        if (each)
            each->most[t] = own.most;
    }
    return all;
}
