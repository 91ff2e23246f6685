// Two edges in one plane whose simplices have one start event each.  If at the
// end they cross in the middle, they do so before; if they first touch at the
// end, an end event is idle.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "base/require.h"
#include "intersect/cascade.h"
#include "kit/worlds.h"

enum {
    PANELS = 2,
    EDGES = 2
};

/// A start event and two end events of each edge, in the plane z = 0.
typedef struct encounter {
    const char *key, *title;
    double start[EDGES][2], end[EDGES][2][2];
} encounter;

static const encounter encounters[PANELS] = {
    {"crossing",
     "they cross at $t = 1$",
     {{-1, 1.5}, {2, 0.5}},
     {{{0, 0}, {2, 0}}, {{1, -1}, {1, 1}}}},
    {"touching",
     "they touch at $t = 1$",
     {{-1, 1.5}, {2, 0.5}},
     {{{-1, 0}, {1, 0}}, {{1, -1}, {1, 1}}}},
};

static const double before = 0.875; ///< a time at which the left edges cross
static const double step_height = 3;
static const fig_role role[EDGES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};

/// The simplices of an encounter, of edges whose other vertex is not drawn.
typedef struct solved {
    tf_worldline vertex[EDGES][2];
    tf_simplex sweep[EDGES][2];
    double first; ///< when they first intersect
} solved;

static void solve(const encounter *e, solved *s)
{
    for (int k = 0; k < EDGES; k++) {
        for (int i = 0; i < 2; i++) {
            const double start[3] = {e->start[k][0], e->start[k][1], 0};
            const double end[3] = {e->end[k][i][0], e->end[k][i][1], 0};
            s->vertex[k][i] = tf_worldline_between(3, start, end);
        }
        tf_sweep(2, s->vertex[k], s->sweep[k]);
    }
    tf_pair pair = tf_pair_of(&s->sweep[0][1], &s->sweep[1][1], 3);
    tf_intersection found = tf_intersect(&tf_exact, &pair, TF_WITH_POINT);
    TF_REQUIRE(found.verdict == TF_HIT);
    s->first = (found.toi_lo + found.toi_hi) / 2;
}

/// A place of the plane at the time t.
static tf_vector world(double x, double y, double t)
{
    return (tf_vector){{x, y, step_height * t}};
}

/// The ends of an edge's slice at the time t.
static void find_slice(const encounter *e, int edge, double t, tf_vector end[2])
{
    const double *s = e->start[edge];
    for (int i = 0; i < 2; i++) {
        const double *to = e->end[edge][i];
        end[i] =
            world((1 - t) * s[0] + t * to[0], (1 - t) * s[1] + t * to[1], t);
    }
}

/// Where the lines of the two slices cross.
static tf_vector find_crossing(const encounter *e, double t)
{
    tf_vector a[2], b[2];
    find_slice(e, 0, t, a);
    find_slice(e, 1, t, b);
    tf_vector u = fig_difference(a[1], a[0]), v = fig_difference(b[1], b[0]);
    tf_vector between = fig_difference(b[0], a[0]);
    double part = fig_cross(between, v).x[2] / fig_cross(u, v).x[2];
    return fig_combination(a[0], part, u);
}

static void label(fig_panel *panel, tf_vector at, const char *text,
                  fig_role color, fig_side side)
{
    fig_panel_label(panel, at,
                    (fig_label){.text = text, .role = color, .side = side});
}

static void draw_simplex(fig_panel *panel, const encounter *e, int edge)
{
    static const char *const name[EDGES][3] = {{"$s$", "$s_1$", "$s_2$"},
                                               {"$r$", "$r_1$", "$r_2$"}};
    static const fig_side side[EDGES][3] = {
        {FIG_SIDE_SE, FIG_SIDE_W, FIG_SIDE_E},
        {FIG_SIDE_E, FIG_SIDE_SE, FIG_SIDE_N}};
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector corner[3] = {
        world(e->start[edge][0], e->start[edge][1], 0),
    };
    find_slice(e, edge, 1, corner + 1);
    fig_scene_triangle(scene, corner, 0,
                       (fig_paint){.role = role[edge], .opacity = 0.4});
    for (int i = 0; i < 3; i++) {
        bool whole = i == 1;
        fig_scene_tube(scene, corner[i], corner[(i + 1) % 3],
                       whole ? FIG_WIDTH_TUBE : FIG_WIDTH_LINE,
                       (fig_paint){.role = role[edge]});
        fig_scene_ball(scene, corner[i], 5, (fig_paint){.role = role[edge]});
        label(panel, corner[i], name[edge][i], role[edge], side[edge][i]);
    }
}

/// The slices shortly before the end, and the contact.
static void draw_contact(fig_panel *panel, const encounter *e, const solved *s)
{
    const fig_paint red = {.role = FIG_ROLE_CONTACT};
    fig_scene *scene = fig_panel_scene(panel);
    for (int k = 0; k < EDGES; k++) {
        tf_vector end[2];
        find_slice(e, k, before, end);
        fig_scene_tube(scene, end[0], end[1], FIG_WIDTH_LINE,
                       (fig_paint){.role = role[k], .shade = 0.3});
    }
    tf_vector first = find_crossing(e, s->first), last = find_crossing(e, 1);
    fig_scene_ball(scene, first, FIG_WIDTH_BALL, red);
    if (s->first == 1)
        return;
    enum {
        PARTS = 16
    };
    tf_vector path[PARTS + 1];
    for (int i = 0; i <= PARTS; i++)
        path[i] = find_crossing(e, s->first + (1 - s->first) * i / PARTS);
    fig_scene_path(scene, PARTS + 1, path, FIG_WIDTH_TUBE, red);
    fig_scene_ball(scene, last, 5, red);
}

/// Let both panels have one camera, and show where time goes.
static void draw_space(fig_panel *panel)
{
    static const char *const name[3] = {"$x$", "$y$", "$t$"};
    for (int i = 0; i < PANELS; i++)
        for (int k = 0; k < EDGES; k++) {
            tf_vector end[2];
            find_slice(&encounters[i], k, 1, end);
            fig_scene_reach(fig_panel_scene(panel), end[0]);
            fig_scene_reach(fig_panel_scene(panel), end[1]);
        }
    fig_panel_axes(panel, world(-2.3, -0.7, 0),
                   (tf_vector){{1, 1, step_height}}, name);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / PANELS;
    for (int i = 0; i < PANELS; i++) {
        const encounter *e = &encounters[i];
        solved s;
        solve(e, &s);
        fig_box box = {width * i + 2, 2, width - 4, fig_page_height(page) - 20};
        fig_panel *panel = fig_page_panel(page, box);
        fig_panel_look(panel, (fig_camera){.azimuth = -28, .elevation = 24});
        fig_panel_margin(panel, 15);
        draw_space(panel);
        for (int k = 0; k < EDGES; k++)
            draw_simplex(panel, e, k);
        draw_contact(panel, e, &s);
        char text[64], key[32];
        snprintf(text, sizeof text, "%s, first at $t = %g$", e->title, s.first);
        fig_page_caption(page, box, text);
        snprintf(key, sizeof key, "%s_first", e->key);
        fig_number(numbers, key, s.first);
    }
    fig_number(numbers, "before", before);
}

const fig_figure fig_contact_at_end = {
    .name = "contact-at-end",
    .title = "Two simplices that first touch at t = 1, and an idle event",
    .width = FIG_PAGE_WIDTH,
    .height = 220,
    .draw = draw,
};
