// The difference of the two elements of a query, around the origin.
//
// For every event of the first element's sweep and every event of the second's
// of the same time, take the difference of their places.  A point's worldline
// and a sweep so give the sweep seen from the point: a triangle of the plane or
// a tetrahedron of space for each of its simplices.  Two simplices of edges
// give a pyramid or a tetrahedron.  The elements meet where these hold the
// origin.
#include "draw/query_parts.h"
#include "kit/worlds.h"

#include <math.h>
#include <string.h>

enum {
    PAIRS = 4
}; ///< of a vertex of the first with one of the second, at most

/// Of the outline of the differences at one time.  It is not filled: where the
/// differences are flat it lies within them.
static const fig_paint present_paint = {.role = FIG_ROLE_CONTACT};

/// Of the dot over the origin, in points.
static const double dot_diameter = 3.2;

/// The differences in a box of their own.
typedef struct difference {
    const fig_shown *shown;
    int pairs;
    tf_worldline pair[PAIRS]; ///< vertex 0 of the first with all of the second
    tf_vector origin;
    bool alike;
} difference;

static difference difference_of(const fig_shown *shown)
{
    const tf_query_kind *kind = shown->kind;
    difference d = {.shown = shown,
                    .pairs = kind->vertices[0] * kind->vertices[1]};
    tf_vector point[2 * PAIRS + 1] = {0};
    for (int i = 0; i < 2 * d.pairs; i++) {
        int pair = i / 2, second = kind->vertices[0] + pair % kind->vertices[1];
        const tf_worldline *from = &shown->given[pair / kind->vertices[1]];
        // Half of each, as the difference may overflow.
        for (int k = 0; k < kind->axes; k++)
            point[i].x[k] = shown->given[second].at[i % 2].x[k] / 2 -
                            from->at[i % 2].x[k] / 2;
    }
    // The last point stays zero: the origin.
    int events = 2 * d.pairs;
    d.alike = fig_fit_points(kind->axes, events + 1, point).alike;
    for (int i = 0; i < events; i++) {
        memcpy(d.pair[i / 2].at[i % 2].x, point[i].x, sizeof point[i].x);
        d.pair[i / 2].at[i % 2].t = i % 2;
    }
    d.origin = point[events];
    return d;
}

static fig_paint piece_paint(const difference *d, int piece)
{
    static const double shade[] = {0, -0.35, 0.2, -0.15};
    if (d->pairs == PAIRS)
        return (fig_paint){FIG_ROLE_NEUTRAL, 0.2, shade[piece]};
    return (fig_paint){fig_shown_role(d->shown, 1), 0.3, shade[piece]};
}

static void add_outline(fig_scene *scene, int count, const tf_vector corner[])
{
    for (int i = 0; i < count; i++)
        fig_scene_tube(scene, corner[i], corner[(i + 1) % count],
                       FIG_WIDTH_LINE, present_paint);
}

/// The difference of a pair at t = 0 or t = 1.
static tf_vector end_of(const difference *d, int pair, int t)
{
    return fig_vector_of(d->pair[pair].at[t].x);
}

// Seen from a point ------------------------------------------------------

static void show_sweep(fig_panel *panel, const difference *d, double t)
{
    fig_scene *scene = fig_panel_scene(panel);
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(d->pairs, d->pair, sweep);
    for (int i = 0; i < d->pairs; i++) {
        tf_vector corner[TF_EVENTS];
        for (int j = 0; j < sweep[i].count; j++)
            corner[j] = fig_vector_of(sweep[i].event[j]->x);
        if (sweep[i].count == 3)
            fig_scene_triangle(scene, corner, FIG_WIDTH_THIN,
                               piece_paint(d, i));
        else
            fig_scene_tetrahedron(scene, corner, FIG_WIDTH_THIN,
                                  piece_paint(d, i));
        if (t < 0)
            continue;
        fig_slice slice = fig_slice_of(&sweep[i], d->shown->kind->axes, t);
        add_outline(scene, slice.count, slice.corner);
    }
}

static void label_sweep(fig_panel *panel, const difference *d)
{
    for (int i = 0; i < 2 * d->pairs; i++) {
        char text[FIG_NAME_TEXT];
        fig_shown_name(d->shown, 1, i / 2, i % 2, text);
        fig_panel_label(
            panel, end_of(d, i / 2, i % 2),
            (fig_label){.text = text,
                        .role = i % 2 == 0 ? FIG_ROLE_START : FIG_ROLE_END,
                        .size = FIG_LETTERS_SMALL,
                        .gap = 3});
    }
}

// Two edges --------------------------------------------------------------

/// A pair of edges' simplices, by their pivots.
typedef struct pivots {
    int pivot[2];
} pivots;

/// The corner where the first edge's slice has its end p, and the second's its
/// end q, at the time t.  Within a simplex the end p moves from an event at
/// t = 0 to one at t = 1.
static tf_vector corner_of(const difference *d, pivots m, int p, int q,
                           double t)
{
    int first[2] = {m.pivot[0] == 1 ? p : 0, m.pivot[0] == 1 ? 1 : p};
    int second[2] = {m.pivot[1] == 1 ? q : 0, m.pivot[1] == 1 ? 1 : q};
    return fig_lerp(end_of(d, 2 * first[0] + second[0], 0),
                    end_of(d, 2 * first[1] + second[1], 1), t);
}

/// The parallelogram of a pair at the time t: at its ends a segment or a point,
/// if not all of an edge is there.
static void find_slice(const difference *d, pivots m, double t,
                       tf_vector corner[4])
{
    static const int ends[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    for (int i = 0; i < 4; i++)
        corner[i] = corner_of(d, m, ends[i][0], ends[i][1], t);
}

static void add_face(fig_scene *scene, tf_vector a, tf_vector b, tf_vector c,
                     fig_paint paint)
{
    fig_scene_triangle(scene, (tf_vector[]){a, b, c}, 0, paint);
}

/// The hull of the slices at t = 0 and t = 1, of which each is a parallelogram,
/// a segment or a point: its sides join those of the one with those of the
/// other.
static void add_hull(fig_scene *scene, const tf_vector start[4],
                     const tf_vector end[4], fig_paint paint)
{
    const fig_paint line = {paint.role, 1, fmax(paint.shade, 0) + 0.25};
    for (int i = 0; i < 4; i++) {
        int next = (i + 1) % 4;
        add_face(scene, start[i], start[next], end[i], paint);
        add_face(scene, start[next], end[next], end[i], paint);
        fig_scene_tube(scene, start[i], start[next], FIG_WIDTH_THIN, line);
        fig_scene_tube(scene, end[i], end[next], FIG_WIDTH_THIN, line);
        fig_scene_tube(scene, start[i], end[i], FIG_WIDTH_THIN, line);
    }
    for (int i = 0; i < 4; i += 2) {
        int next = i + 1, last = (i + 2) % 4;
        add_face(scene, start[i], start[next], start[last], paint);
        add_face(scene, end[i], end[next], end[last], paint);
    }
}

static void show_pairs(fig_panel *panel, const difference *d, double t)
{
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i < 4; i++) {
        pivots m = {{1 - i / 2, 1 - i % 2}};
        tf_vector start[4], end[4], now[4];
        find_slice(d, m, 0, start);
        find_slice(d, m, 1, end);
        add_hull(scene, start, end, piece_paint(d, i));
        if (t < 0)
            continue;
        find_slice(d, m, t, now);
        add_outline(scene, 4, now);
    }
}

// The ends and the origin ------------------------------------------------

/// The outline of the differences at t = 0 or t = 1.
static void add_end(fig_scene *scene, const difference *d, int t)
{
    static const int around[] = {0, 1, 3, 2};
    fig_paint paint = {.role = t == 0 ? FIG_ROLE_START : FIG_ROLE_END};
    for (int i = 0; i < d->pairs; i++) {
        int next = (i + 1) % d->pairs;
        bool edges = d->pairs == PAIRS;
        fig_scene_tube(scene, end_of(d, edges ? around[i] : i, t),
                       end_of(d, edges ? around[next] : next, t), 1.6, paint);
    }
}

/// Look at the plane from above, always.
static void look(fig_panel *panel, int axes)
{
    const fig_camera above = {.elevation = 90};
    if (axes == 2) {
        fig_panel_look(panel, above);
        fig_panel_fix(panel);
    } else {
        fig_panel_look(panel, fig_shown_camera);
    }
}

/// The ball tells the depth; the dot shows it through whatever is before it.
static void mark_origin(fig_page *page, fig_panel *panel, const difference *d)
{
    bool edges = d->pairs == PAIRS;
    fig_role role = fig_shown_hits(d->shown) ? FIG_ROLE_CONTACT
                    : edges                  ? FIG_ROLE_INK
                                             : FIG_ROLE_POINT;
    fig_scene_ball(fig_panel_scene(panel), d->origin, FIG_WIDTH_BALL,
                   (fig_paint){.role = role});
    fig_point at = fig_panel_project(panel, d->origin);
    fig_page_dot(page, at.x, at.y, dot_diameter, (fig_paint){.role = role});
    char text[FIG_NAME_TEXT] = "$0$";
    if (!edges)
        fig_shown_name(d->shown, 0, 0, 0, text);
    fig_panel_label(panel, d->origin,
                    (fig_label){.text = text, .role = role, .leader = true});
}

bool fig_show_difference(fig_page *page, fig_panel *panel,
                         const fig_shown *shown, double t)
{
    difference d = difference_of(shown);
    fig_scene *scene = fig_panel_scene(panel);
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
