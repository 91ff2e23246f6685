// Two scripted walls that close upon a chain: the start, what zones make of it,
// and what resolving returns.
#include "base/require.h"
#include "fast/detect.h"
#include "kit/figures.h"

#include "renderer/plot.h"
#include "response/gauss_seidel.h"
#include "response/resolve.h"
#include "response/zones.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum {
    CHAIN = 9,
    WALL = 2,
    VERTICES = CHAIN + 2 * WALL,
    EDGES = CHAIN - 1 + 2,
    NUMBERS = 2 * VERTICES,
    ROUNDS = 20,
    PANELS = 3
};

/// Where the walls are, how far up they reach, and how far each should go.
static const double wall_at = 1, wall_top = 1.9, wall_move = 1.45;

/// Half of the chain's width and height.
static const double chain_width = 0.18, chain_height = 1.35;

static const double separation = 0.05;

typedef struct scene {
    tf_mesh mesh;
    int edge[2 * EDGES];
    double start[NUMBERS], proposed[NUMBERS], inverse_mass[VERTICES];
} scene;

// The scene -------------------------------------------------------------------

static void place_chain(scene *s)
{
    for (int v = 0; v < CHAIN; v++) {
        double *x = s->start + 2 * (ptrdiff_t)v;
        x[0] = v % 2 == 0 ? -chain_width : chain_width;
        x[1] = chain_height * (2.0 * v / (CHAIN - 1) - 1);
        s->inverse_mass[v] = 1;
    }
}

static void place_walls(scene *s)
{
    for (int v = CHAIN; v < VERTICES; v++) {
        double *x = s->start + 2 * (ptrdiff_t)v;
        x[0] = v < CHAIN + WALL ? -wall_at : wall_at;
        x[1] = (v - CHAIN) % WALL == 0 ? -wall_top : wall_top;
    }
}

static void make_scene(scene *s)
{
    memset(s, 0, sizeof *s);
    place_chain(s);
    place_walls(s);
    memcpy(s->proposed, s->start, sizeof s->start);
    for (int v = CHAIN; v < VERTICES; v++)
        s->proposed[2 * (ptrdiff_t)v] +=
            v < CHAIN + WALL ? wall_move : -wall_move;
    for (int e = 0; e < EDGES; e++) {
        int first = e < CHAIN - 1 ? e : CHAIN + WALL * (e - CHAIN + 1);
        s->edge[2 * (ptrdiff_t)e] = first;
        s->edge[2 * e + 1] = first + 1;
    }
    s->mesh = (tf_mesh){
        .axes = 2, .vertices = VERTICES, .edges = EDGES, .edge = s->edge};
}

// Answers ---------------------------------------------------------------------

static tf_contacts detect(tf_surface *surface, const scene *s,
                          const double end[])
{
    tf_motion motion = {2, VERTICES, s->start, end};
    tf_contacts found;
    TF_REQUIRE(tf_surface_detect(surface, &motion, NULL, &found, NULL) ==
               TF_OK);
    return found;
}

/// Goes through rounds of zones alone, from the proposal.  Returns how many
/// contacts are left.
static size_t answer_by_zones(tf_surface *surface, const scene *s, double end[])
{
    double unpushed[2 * VERTICES];
    tf_step step = {.axes = 2,
                    .vertices = VERTICES,
                    .start = s->start,
                    .proposed = s->proposed,
                    .inverse_mass = s->inverse_mass,
                    .end = end,
                    .unpushed = unpushed};
    tf_contact_rule rule = {.separation = separation, .base = s->proposed};
    tf_zone_options choice = {.solver = &tf_gauss_seidel, .sweeps = 30};
    tf_zones zones = {0};
    tf_zone_statistics statistics = {.smallest_gap = INFINITY};
    memcpy(end, s->proposed, sizeof s->proposed);
    memcpy(unpushed, s->proposed, sizeof s->proposed);
    TF_REQUIRE(tf_zones_begin(&zones, &step));
    tf_contacts found = detect(surface, s, end);
    for (int round = 0; round < ROUNDS && found.any; round++) {
        TF_REQUIRE(tf_zones_add(&zones, &step, &found, &rule, &statistics));
        TF_REQUIRE(tf_zones_solve(&zones, &step, &rule, &choice, &statistics));
        found = detect(surface, s, end);
    }
    tf_zones_free(&zones);
    return found.count;
}

static tf_response_report resolve(tf_surface *surface, const scene *s,
                                  double end[])
{
    const tf_response_options options = {.separation = separation};
    const tf_response_report *lent;
    tf_resolver *resolver;
    memcpy(end, s->proposed, sizeof s->proposed);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_step_resolve(resolver, VERTICES, s->start, end,
                               s->inverse_mass, &options, &lent,
                               NULL) == TF_OK);
    tf_response_report report = *lent;
    tf_resolver_free(resolver);
    return report;
}

// Drawing ---------------------------------------------------------------------

static void draw_edges(fig_page *page, const fig_plot *plot, const scene *s,
                       const double x[], double shade)
{
    for (int e = 0; e < EDGES; e++) {
        const double *a = x + 2 * (ptrdiff_t)s->edge[(ptrdiff_t)2 * e];
        const double *b = x + 2 * (ptrdiff_t)s->edge[2 * e + 1];
        bool is_wall = e >= CHAIN - 1;
        fig_plot_curve(page, plot, 2, (fig_point[]){{a[0], a[1]}, {b[0], b[1]}},
                       (fig_stroke){.paint = {.role = is_wall ? FIG_ROLE_EDGE
                                                              : FIG_ROLE_POINT,
                                              .shade = shade},
                                    .width = is_wall ? 3 : 1.6});
    }
    for (int v = 0; v < CHAIN && shade == 0; v++)
        fig_plot_dot(page, plot, x[(ptrdiff_t)2 * v], x[2 * v + 1], 4,
                     FIG_ROLE_POINT);
}

/// Where the walls should go.
static void draw_arrows(fig_page *page, const fig_plot *plot, const scene *s)
{
    for (int wall = 0; wall < 2; wall++) {
        ptrdiff_t place = 2 * (ptrdiff_t)(CHAIN + WALL * wall);
        double y = wall == 0 ? 1.65 : -1.65;
        fig_plot_curve(
            page, plot, 2,
            (fig_point[]){{s->start[place], y}, {s->proposed[place], y}},
            (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .arrow = true});
    }
}

static fig_plot begin_panel(fig_page *page, int i, const char *title)
{
    double width = fig_page_width(page) / PANELS;
    fig_plot plot = {.box = {width * i + 4, 18, width - 8, 164},
                     .x = {-1.45, 2.05},
                     .y = {-2.06, 2.06}};
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_page_title(page, plot.box, title);
    return plot;
}

static void draw(fig_page *page, FILE *numbers)
{
    scene s;
    double by_zones[NUMBERS], resolved[NUMBERS];
    tf_surface *surface;
    make_scene(&s);
    TF_REQUIRE(tf_surface_create(&s.mesh, &surface, NULL) == TF_OK);
    size_t left = answer_by_zones(surface, &s, by_zones);
    tf_response_report report = resolve(surface, &s, resolved);
    tf_surface_free(surface);

    fig_plot plot = begin_panel(page, 0, "the start");
    draw_edges(page, &plot, &s, s.start, 0);
    draw_arrows(page, &plot, &s);
    plot = begin_panel(page, 1, "zones");
    draw_edges(page, &plot, &s, s.start, -0.6);
    draw_edges(page, &plot, &s, by_zones, 0);
    plot = begin_panel(page, 2, "resolved");
    draw_edges(page, &plot, &s, resolved, 0);

    fig_number(numbers, "first_contacts", (double)report.first_contacts);
    fig_number(numbers, "left", (double)left);
    fig_number(numbers, "zone_rounds", ROUNDS);
    fig_number(numbers, "held", report.held);
    fig_number(numbers, "followed", report.followed);
    fig_number(numbers, "meeting", wall_at / wall_move);
}

const fig_figure fig_closing_walls = {
    .name = "closing-walls",
    .title = "Two walls close upon a chain",
    .width = FIG_PAGE_WIDTH,
    .height = 188,
    .draw = draw,
};
