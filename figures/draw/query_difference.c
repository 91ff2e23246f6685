// The difference of the two elements of a query, around the origin.
//
// For every event of the first element's sweep and every event of the second's
// of the same time, take the difference of their places.  A point's worldline
// and a sweep so give the sweep seen from the point: a triangle of the plane or
// a tetrahedron of space for each of its simplices.  Two simplices of edges
// give a pyramid or a tetrahedron.  The elements meet where these hold the
// origin.
#include "draw/query_parts.h"
#include "worlds.h"

#include "stage/vector.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    PAIRS = 4
}; ///< of a vertex of the first with one of the second, at most

/// Of the outline of the differences at one time.  It is not filled: where the
/// differences are flat it lies within them.
static const tf_paint present_paint = {.role = TF_ROLE_CONTACT};

/// Of the dot over the origin, in points.
static const double dot_diameter = 3.2;

/// The differences in a box of their own.
typedef struct difference {
    const tf_shown *shown;
    int pairs;
    tf_worldline pair[PAIRS]; ///< vertex 0 of the first with all of the second
    double origin[3];
    bool alike;
} difference;

static difference difference_of(const tf_shown *shown)
{
    const tf_query_kind *kind = shown->kind;
    difference d = {.shown = shown,
                    .pairs = kind->vertices[0] * kind->vertices[1]};
    double point[2 * PAIRS + 1][3] = {0};
    for (int i = 0; i < 2 * d.pairs; i++) {
        int pair = i / 2, second = kind->vertices[0] + pair % kind->vertices[1];
        const tf_worldline *from = &shown->asked[pair / kind->vertices[1]];
        // Half of each, as the difference may overflow.
        for (int k = 0; k < kind->axes; k++)
            point[i][k] = shown->asked[second].at[i % 2].x[k] / 2 -
                          from->at[i % 2].x[k] / 2;
    }
    // The last point stays zero: the origin.
    int events = 2 * d.pairs;
    d.alike = tf_fit_points(kind->axes, events + 1, point).alike;
    for (int i = 0; i < events; i++) {
        memcpy(d.pair[i / 2].at[i % 2].x, point[i], sizeof point[i]);
        d.pair[i / 2].at[i % 2].t = i % 2;
    }
    memcpy(d.origin, point[events], sizeof d.origin);
    return d;
}

static tf_paint piece_paint(const difference *d, int piece)
{
    static const double shade[] = {0, -0.35, 0.2, -0.15};
    if (d->pairs == PAIRS)
        return (tf_paint){TF_ROLE_NEUTRAL, 0.2, shade[piece]};
    return (tf_paint){tf_shown_role(d->shown, 1), 0.3, shade[piece]};
}

static void add_outline(tf_scene *scene, int count, const double corner[][3])
{
    for (int i = 0; i < count; i++)
        tf_scene_tube(scene, corner[i], corner[(i + 1) % count], TF_WIDTH_LINE,
                      present_paint);
}

// Seen from a point ------------------------------------------------------

static void show_sweep(tf_panel *panel, const difference *d, double t)
{
    tf_scene *scene = tf_panel_scene(panel);
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(d->pairs, d->pair, sweep);
    for (int i = 0; i < d->pairs; i++) {
        double corner[TF_EVENTS][3];
        for (int j = 0; j < sweep[i].count; j++)
            memcpy(corner[j], sweep[i].event[j]->x, sizeof corner[j]);
        if (sweep[i].count == 3)
            tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                              piece_paint(d, i));
        else
            tf_scene_tetrahedron(scene, (const double(*)[3])corner,
                                 TF_WIDTH_THIN, piece_paint(d, i));
        if (t < 0)
            continue;
        tf_slice slice = tf_slice_of(&sweep[i], d->shown->kind->axes, t);
        add_outline(scene, slice.count, (const double(*)[3])slice.corner);
    }
}

static void label_sweep(tf_panel *panel, const difference *d)
{
    for (int i = 0; i < 2 * d->pairs; i++) {
        char text[16];
        snprintf(text, sizeof text, "$%s$",
                 tf_shown_name(d->shown, 1, i / 2, i % 2));
        tf_panel_label(
            panel, d->pair[i / 2].at[i % 2].x,
            (tf_label){.text = text,
                       .role = i % 2 == 0 ? TF_ROLE_START : TF_ROLE_END,
                       .size = TF_LETTERS_SMALL,
                       .gap = 3});
    }
}

// Two edges --------------------------------------------------------------

/// A pair of edges' simplices, by their movers.
typedef struct movers {
    int of[2];
} movers;

/// The corner where the first edge's slice has its end p, and the second's its
/// end q, at the time t.  Within a simplex the end p moves from an event at
/// t = 0 to one at t = 1.
static void find_corner(const difference *d, movers m, int p, int q, double t,
                        double corner[3])
{
    int first[2] = {m.of[0] == 1 ? p : 0, m.of[0] == 1 ? 1 : p};
    int second[2] = {m.of[1] == 1 ? q : 0, m.of[1] == 1 ? 1 : q};
    memset(corner, 0, 3 * sizeof *corner);
    for (int late = 0; late < 2; late++)
        tf_add(corner, late ? t : 1 - t,
               d->pair[2 * first[late] + second[late]].at[late].x, corner);
}

/// The parallelogram of a pair at the time t: at its ends a segment or a point,
/// if not all of an edge is there.
static void find_slice(const difference *d, movers m, double t,
                       double corner[4][3])
{
    static const int ends[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    for (int i = 0; i < 4; i++)
        find_corner(d, m, ends[i][0], ends[i][1], t, corner[i]);
}

static void add_face(tf_scene *scene, const double a[3], const double b[3],
                     const double c[3], tf_paint paint)
{
    double corner[3][3];
    memcpy(corner[0], a, sizeof corner[0]);
    memcpy(corner[1], b, sizeof corner[1]);
    memcpy(corner[2], c, sizeof corner[2]);
    tf_scene_triangle(scene, (const double(*)[3])corner, 0, paint);
}

/// The hull of the slices at t = 0 and t = 1, of which each is a parallelogram,
/// a segment or a point: its sides join those of the one with those of the
/// other.
static void add_hull(tf_scene *scene, const double start[4][3],
                     const double end[4][3], tf_paint paint)
{
    const tf_paint line = {paint.role, 1, fmax(paint.shade, 0) + 0.25};
    for (int i = 0; i < 4; i++) {
        int next = (i + 1) % 4;
        add_face(scene, start[i], start[next], end[i], paint);
        add_face(scene, start[next], end[next], end[i], paint);
        tf_scene_tube(scene, start[i], start[next], TF_WIDTH_THIN, line);
        tf_scene_tube(scene, end[i], end[next], TF_WIDTH_THIN, line);
        tf_scene_tube(scene, start[i], end[i], TF_WIDTH_THIN, line);
    }
    for (int i = 0; i < 4; i += 2) {
        int next = i + 1, last = (i + 2) % 4;
        add_face(scene, start[i], start[next], start[last], paint);
        add_face(scene, end[i], end[next], end[last], paint);
    }
}

static void show_pairs(tf_panel *panel, const difference *d, double t)
{
    tf_scene *scene = tf_panel_scene(panel);
    for (int i = 0; i < 4; i++) {
        movers m = {{1 - i / 2, 1 - i % 2}};
        double start[4][3], end[4][3], now[4][3];
        find_slice(d, m, 0, start);
        find_slice(d, m, 1, end);
        add_hull(scene, (const double(*)[3])start, (const double(*)[3])end,
                 piece_paint(d, i));
        if (t < 0)
            continue;
        find_slice(d, m, t, now);
        add_outline(scene, 4, (const double(*)[3])now);
    }
}

// The ends and the origin ------------------------------------------------

/// The outline of the differences at t = 0 or t = 1.
static void add_end(tf_scene *scene, const difference *d, int t)
{
    static const int around[] = {0, 1, 3, 2};
    tf_paint paint = {.role = t == 0 ? TF_ROLE_START : TF_ROLE_END};
    for (int i = 0; i < d->pairs; i++) {
        int next = (i + 1) % d->pairs;
        bool edges = d->pairs == PAIRS;
        tf_scene_tube(scene, d->pair[edges ? around[i] : i].at[t].x,
                      d->pair[edges ? around[next] : next].at[t].x, 1.6, paint);
    }
}

/// Look at the plane from above, always.
static void look(tf_panel *panel, int axes)
{
    const tf_camera above = {.elevation = 90};
    if (axes == 2) {
        tf_panel_look(panel, above);
        tf_panel_fix(panel);
    } else {
        tf_panel_look(panel, tf_shown_camera);
    }
}

/// The ball tells the depth; the dot shows it through whatever is before it.
static void mark_origin(tf_page *page, tf_panel *panel, const difference *d)
{
    bool edges = d->pairs == PAIRS;
    tf_role role = tf_shown_hits(d->shown) ? TF_ROLE_CONTACT
                   : edges                 ? TF_ROLE_INK
                                           : TF_ROLE_POINT;
    double at[2];
    tf_scene_ball(tf_panel_scene(panel), d->origin, TF_WIDTH_BALL,
                  (tf_paint){.role = role});
    tf_panel_project(panel, d->origin, at);
    tf_page_dot(page, at[0], at[1], dot_diameter, (tf_paint){.role = role});
    tf_panel_label(panel, d->origin,
                   (tf_label){.text = edges ? "$0$" : "$p$",
                              .role = role,
                              .leader = true});
}

bool tf_show_difference(tf_page *page, tf_panel *panel, const tf_shown *shown,
                        double t)
{
    difference d = difference_of(shown);
    tf_scene *scene = tf_panel_scene(panel);
    look(panel, shown->kind->axes);
    bool edges = d.pairs == PAIRS;
    if (edges)
        show_pairs(panel, &d, t);
    else
        show_sweep(panel, &d, t);
    add_end(scene, &d, 0);
    add_end(scene, &d, 1);
    if (!edges)
        label_sweep(panel, &d);
    mark_origin(page, panel, &d);
    return d.alike;
}
