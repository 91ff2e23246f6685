// A chain that falls into a box, with more and with less friction.
#include "kit/cloth_run.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    LINKS = 98,
    STEPS = 300,
    FRICTIONS = 3
};

static const struct {
    const char *name;
    double friction;
} choice[FRICTIONS] = {{"none", 0}, {"some", 0.3}, {"much", 1}};

static const fig_cloth_run *run_with(double friction, double separation)
{
    return fig_cloth_run_of(&(fig_cloth_plan){.scene = "plane-chain",
                                              .size = LINKS,
                                              .steps = STEPS,
                                              .chosen = true,
                                              .friction = friction,
                                              .separation = separation});
}

static void draw_edges(fig_page *page, const fig_plot *plot, const double x[],
                       int edges, const int edge[], fig_stroke stroke)
{
    for (int e = 0; e < edges; e++) {
        const double *a = x + 2 * (size_t)edge[2 * (size_t)e];
        const double *b = x + 2 * (size_t)edge[2 * (size_t)e + 1];
        fig_plot_curve(page, plot, 2, (fig_point[]){{a[0], a[1]}, {b[0], b[1]}},
                       stroke);
    }
}

static void draw_run(fig_page *page, const fig_cloth_run *run, int i)
{
    const tf_body *body = &run->simulation->base.setup.body;
    // The walls are cut off above the heap.
    fig_plot plot = {.box = {4, 18 + 74.0 * i, 374, 55},
                     .x = {-0.37, 0.37},
                     .y = {-0.03, 0.0788}};
    char title[32];
    snprintf(title, sizeof title, "friction %g", choice[i].friction);
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_page_title(page, plot.box, title);
    const double *x = fig_cloth_run_at(run, STEPS);
    draw_edges(page, &plot, x, LINKS, body->edge,
               (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    draw_edges(page, &plot, x, body->edges - LINKS,
               body->edge + 2 * (size_t)LINKS,
               (fig_stroke){.paint = {.role = FIG_ROLE_INK}, .width = 1.6});
}

static double height_of(const fig_cloth_run *run)
{
    const double *x = fig_cloth_run_at(run, STEPS);
    double most = 0;
    for (int v = 0; v <= LINKS; v++)
        most = fmax(most, x[2 * v + 1]);
    return 1000 * most;
}

static void print_cost(FILE *numbers, const fig_cloth_run *run,
                       const char *name)
{
    char key[32];
    double contacts = 0, rounds = 0;
    for (int i = 1; i <= STEPS; i++) {
        contacts += (double)run->step[i].report.contacts;
        for (int level = 0; level < TF_LEVELS; level++)
            rounds += run->step[i].report.rounds[level];
    }
    snprintf(key, sizeof key, "contacts_%s", name);
    fig_number(numbers, key, contacts);
    snprintf(key, sizeof key, "rounds_%s", name);
    fig_number(numbers, key, rounds);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < FRICTIONS; i++) {
        char key[32];
        const fig_cloth_run *run = run_with(choice[i].friction, 0);
        draw_run(page, run, i);
        snprintf(key, sizeof key, "height_%s", choice[i].name);
        fig_number(numbers, key, height_of(run));
        print_cost(numbers, run, choice[i].name);
    }
    print_cost(numbers, run_with(choice[1].friction, -1), "close");
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "links", LINKS);
}

const fig_figure fig_three_frictions = {
    .name = "three-frictions",
    .title = "A chain in a box, with more and with less friction",
    .width = FIG_PAGE_WIDTH,
    .height = 224,
    .draw = draw,
};
