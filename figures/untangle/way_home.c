// Curves in the plane: the input, the clear state that was found, and the output
// after the return.
#include "base/require.h"
#include "kit/figures.h"
#include "renderer/plot.h"
#include "untangle/untangle.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    CURVES = 2,
    POINTS = 49,
    VERTICES = CURVES * POINTS,
    EDGES = CURVES * (POINTS - 1),
    NUMBERS = 2 * VERTICES,
    STATES = 3
};

typedef struct states {
    int edge[2 * EDGES];
    double x[STATES][NUMBERS];
    tf_untangle_report report;
} states;

static void make_curves(states *s)
{
    int *edge = s->edge;
    for (int v = 0; v < VERTICES; v++) {
        double along = 2. * (v % POINTS) / (POINTS - 1) - 1, *x = s->x[0];
        bool upper = v >= POINTS;
        x[2 * (ptrdiff_t)v] = 1.2 * along + (upper ? 0.007 : 0);
        x[2 * (ptrdiff_t)v + 1] =
            upper ? 0.16 - 0.5 * exp(-60 * (along + 0.45) * (along + 0.45)) -
                        0.28 * exp(-30 * (along - 0.4) * (along - 0.4))
                  : 0.05 * sin(4 * along);
        if (v % POINTS == POINTS - 1)
            continue;
        *edge++ = v;
        *edge++ = v + 1;
    }
}

static void untangle(states *s, int state, int without)
{
    tf_mesh mesh = {
        .axes = 2, .vertices = VERTICES, .edges = EDGES, .edge = s->edge};
    tf_untangle_options options = {.size = sizeof options, .without = without};
    tf_surface *surface;
    tf_resolver *resolver;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_untangle(resolver, VERTICES, s->x[0], s->x[state], &options,
                           &s->report, NULL, NULL) == TF_OK);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

/// How far a vertex is from where it was.
static double moved(const states *s, int state, int v)
{
    const double *a = s->x[0] + 2 * (ptrdiff_t)v,
                 *b = s->x[state] + 2 * (ptrdiff_t)v;
    return hypot(a[0] - b[0], a[1] - b[1]);
}

static void draw_curves(fig_page *page, const fig_plot *plot, const double x[],
                        double shade, double width)
{
    for (int c = 0; c < CURVES; c++) {
        fig_point at[POINTS];
        for (int i = 0; i < POINTS; i++) {
            const double *from = x + 2 * (ptrdiff_t)(c * POINTS + i);
            at[i] = (fig_point){from[0], from[1]};
        }
        fig_plot_curve(page, plot, POINTS, at,
                       (fig_stroke){.paint = {.role = c == 0 ? FIG_ROLE_TRIANGLE
                                                             : FIG_ROLE_EDGE,
                                              .shade = shade},
                                    .width = width});
    }
}

/// Dots at the vertices: large where they are not where they were.
static void draw_vertices(fig_page *page, const fig_plot *plot, const states *s,
                          int state)
{
    for (int v = 0; v < VERTICES; v++) {
        const double *x = s->x[state] + 2 * (ptrdiff_t)v;
        bool went = moved(s, state, v) > 0;
        fig_plot_dot(page, plot, x[0], x[1], went ? 3.4 : 2,
                     went         ? FIG_ROLE_POINT
                     : v < POINTS ? FIG_ROLE_TRIANGLE
                                  : FIG_ROLE_EDGE);
    }
}

static void draw_state(fig_page *page, const states *s, int state,
                       FILE *numbers)
{
    static const char *const title[STATES] = {"the input", "a clear state",
                                              "after the return"};
    static const char *const key[STATES] = {"input", "found", "home"};
    double height = (fig_page_height(page) - 6) / STATES;
    fig_plot plot = {.box = {92, 3 + height * state, 288, height - 4},
                     .x = {-1.22, 1.22},
                     .y = {-0.4, -0.4 + 2.44 * (height - 4) / 288}};
    if (state > 0)
        draw_curves(page, &plot, s->x[0], -0.7, FIG_WIDTH_LINE);
    draw_curves(page, &plot, s->x[state], 0, 1.4);
    draw_vertices(page, &plot, s, state);
    fig_page_text(page, 0, plot.box.y + height / 2, FIG_ALIGN_LEFT,
                  title[state], FIG_LETTERS_SMALL, FIG_ROLE_INK);
    double sum = 0;
    int count = 0;
    for (int v = 0; v < VERTICES; v++) {
        sum += moved(s, state, v) * moved(s, state, v);
        count += moved(s, state, v) > 0;
    }
    char name[24];
    snprintf(name, sizeof name, "%s_moved", key[state]);
    fig_number(numbers, name, count);
    snprintf(name, sizeof name, "%s_deviation", key[state]);
    fig_number(numbers, name, sqrt(sum / VERTICES) / s->report.edge);
}

static void draw(fig_page *page, FILE *numbers)
{
    states s = {0};
    make_curves(&s);
    untangle(&s, 1, TF_RUNG_RETURN);
    untangle(&s, 2, 0);
    for (int state = 0; state < STATES; state++)
        draw_state(page, &s, state, numbers);
    fig_number(numbers, "vertices", VERTICES);
    fig_number(numbers, "before", (double)s.report.before);
    fig_number(numbers, "left", (double)s.report.left);
    fig_number(numbers, "rounds", s.report.rounds);
}

const fig_figure fig_way_home = {
    .name = "way-home",
    .title = "Curves, untangled, and on their way home",
    .width = FIG_PAGE_WIDTH,
    .height = 236,
    .draw = draw,
};
