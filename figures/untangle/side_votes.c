// Two rings in the plane that overlap: what votes, what the first push proposes,
// and the clear state that the rounds lead to.
#include "base/require.h"
#include "kit/figures.h"
#include "renderer/plot.h"
#include "untangle/push.h"
#include "untangle/untangle.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    RINGS = 2,
    POINTS = 36,
    VERTICES = RINGS * POINTS,
    EDGES = VERTICES,
    PANELS = 2
};

/// By how much the moves are enlarged: they are half an edge at most.
static const double enlarged = 3;

typedef struct rings {
    double x[2 * VERTICES];
    int edge[2 * EDGES];
    bool fixed[VERTICES];
    tf_tangle tangle;
    tf_push push;
    tf_change change;
    double clear[2 * VERTICES]; ///< the state that is found
    tf_untangle_report report;
} rings;

static void make_rings(rings *c)
{
    const double pi = acos(-1);
    for (int v = 0; v < VERTICES; v++) {
        bool left = v < POINTS;
        double *x = c->x + 2 * (ptrdiff_t)v;
        double turn = 2 * pi * (v % POINTS + 0.3) / POINTS;
        x[0] = (left ? -0.4 : 0.4) + 0.52 * cos(turn);
        x[1] = (left ? 0 : 0.06) + 0.42 * sin(turn);
        c->edge[2 * (ptrdiff_t)v] = v;
        c->edge[2 * v + 1] = v % POINTS == POINTS - 1 ? v - POINTS + 1 : v + 1;
    }
}

// What the library finds ------------------------------------------------------

static void look(rings *c, tf_surface *surface)
{
    c->tangle = (tf_tangle){.surface = surface, .in = c->x, .fixed = c->fixed};
    TF_REQUIRE(tf_tangle_begin(&c->tangle));
    TF_REQUIRE(tf_tangle_check(&c->tangle, c->x) == TF_OK);
    TF_REQUIRE(tf_push_begin(&c->push, &c->tangle));
    TF_REQUIRE(tf_change_begin(&c->change, &c->tangle));
    TF_REQUIRE(tf_push_propose(&c->push, &c->tangle, c->x, &c->change));
    TF_REQUIRE(tf_change_finish(&c->change, &c->tangle));
}

static void untangle(rings *c, tf_surface *surface)
{
    const tf_untangle_options options = {.size = sizeof options,
                                         .without = TF_RUNG_RETURN};
    tf_resolver *resolver;
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_untangle(resolver, VERTICES, c->x, c->clear, &options,
                           &c->report, NULL, NULL) == TF_OK);
    tf_resolver_free(resolver);
}

static void release(rings *c)
{
    tf_change_free(&c->change);
    tf_push_free(&c->push);
    tf_tangle_end(&c->tangle);
}

// Drawing -----------------------------------------------------------------------

static bool is_wrong(const rings *c, int vertex)
{
    const tf_regions *regions = &c->push.regions;
    return tf_is_wrong(regions, &c->tangle.near, regions->region[vertex]);
}

static void draw_rings(fig_page *page, const fig_plot *plot, const rings *c,
                       const double x[])
{
    for (int e = 0; e < EDGES; e++) {
        const double *a = x + 2 * (ptrdiff_t)c->edge[2 * (ptrdiff_t)e];
        const double *b = x + 2 * (ptrdiff_t)c->edge[2 * e + 1];
        fig_role role = e < POINTS ? FIG_ROLE_TRIANGLE : FIG_ROLE_EDGE;
        fig_plot_curve(page, plot, 2, (fig_point[]){{a[0], a[1]}, {b[0], b[1]}},
                       (fig_stroke){.paint = {.role = role}, .width = 1.6});
    }
    for (int v = 0; v < VERTICES; v++) {
        fig_role role = is_wrong(c, v) ? FIG_ROLE_POINT
                        : v < POINTS   ? FIG_ROLE_TRIANGLE
                                       : FIG_ROLE_EDGE;
        fig_plot_dot(page, plot, x[2 * (ptrdiff_t)v], x[2 * v + 1],
                     is_wrong(c, v) ? 4.2 : 3, role);
    }
}

static void draw_arrow(fig_page *page, const fig_plot *plot,
                       const double from[], fig_point by, fig_role role)
{
    fig_point line[2] = {fig_plot_place(plot, from[0], from[1]),
                         fig_plot_place(plot, from[0] + by.x, from[1] + by.y)};
    if (hypot(line[1].x - line[0].x, line[1].y - line[0].y) > 3)
        fig_page_line(page, 2, line,
                      (fig_stroke){.paint = {.role = role}, .arrow = true});
}

/// Draws the votes of the right ring's breaches, and returns how many there are: each
/// points across the facet, to the side of the right end.
static int draw_votes(fig_page *page, const fig_plot *plot, const rings *c)
{
    const tf_breaches *all = &c->push.breaches;
    int votes = 0;
    for (size_t i = 0; i < all->count; i++) {
        const tf_breach *breach = &all->breach[i];
        const int *end = c->tangle.near.facet + 2 * (ptrdiff_t)breach->facet;
        if (end[0] >= POINTS)
            continue;
        const double *a = c->x + 2 * (ptrdiff_t)end[0];
        const double *b = c->x + 2 * (ptrdiff_t)end[1];
        fig_point across = {a[1] - b[1], b[0] - a[0]};
        double back =
            across.x * breach->inward.x[0] + across.y * breach->inward.x[1];
        double scale = (back > 0 ? -0.2 : 0.2) / hypot(across.x, across.y);
        draw_arrow(page, plot, breach->place.x,
                   (fig_point){scale * across.x, scale * across.y},
                   FIG_ROLE_CONTACT);
        fig_plot_dot(page, plot, breach->place.x[0], breach->place.x[1],
                     FIG_WIDTH_BALL, FIG_ROLE_CONTACT);
        votes++;
    }
    return votes;
}

static fig_plot panel(fig_page *page, int i, const char *title)
{
    double width = fig_page_width(page) / PANELS;
    fig_plot plot = {.box = {width * i + 4, 18, width - 8, 96},
                     .x = {-1, 1},
                     .y = {-0.5, -0.5 + 2. * 96 / (width - 8)}};
    fig_page_title(page, plot.box, title);
    return plot;
}

static void draw_moves(fig_page *page, const fig_plot *plot, const rings *c)
{
    for (int v = 0; v < VERTICES; v++) {
        const double *move = c->change.move[v].x;
        draw_arrow(page, plot, c->x + 2 * (ptrdiff_t)v,
                   (fig_point){enlarged * move[0], enlarged * move[1]},
                   FIG_ROLE_INK);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    rings c = {.report = {0}};
    make_rings(&c);
    tf_mesh mesh = {
        .axes = 2, .vertices = VERTICES, .edges = EDGES, .edge = c.edge};
    tf_surface *surface;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    look(&c, surface);
    untangle(&c, surface);
    fig_plot before = panel(page, 0, "two votes, and the first moves");
    fig_plot after = panel(page, 1, "clear");
    draw_rings(page, &before, &c, c.x);
    draw_moves(page, &before, &c);
    int votes = draw_votes(page, &before, &c), wrong = 0;
    draw_rings(page, &after, &c, c.clear);
    for (int v = 0; v < VERTICES; v++)
        wrong += is_wrong(&c, v);
    fig_number(numbers, "votes", votes);
    fig_number(numbers, "breaches", (double)c.push.breaches.count);
    fig_number(numbers, "wrong", wrong);
    fig_number(numbers, "enlarged", enlarged);
    fig_number(numbers, "left", (double)c.report.left);
    fig_number(numbers, "rounds", c.report.rounds);
    release(&c);
    tf_surface_free(surface);
}

const fig_figure fig_side_votes = {
    .name = "side-votes",
    .title = "Two rings that overlap: votes and pushes",
    .width = FIG_PAGE_WIDTH,
    .height = 118,
    .draw = draw,
};
