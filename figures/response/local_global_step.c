// A chain between two fixed ends, and what its links want.
#include "base/require.h"
#include "kit/figures.h"

#include "renderer/plot.h"
#include "simulate/dynamics.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    LINKS = 8,
    VERTICES = LINKS + 1,
    NUMBERS = 2 * VERTICES,
    ITERATIONS = 10
};

static const double stiffness = 40, mass = 0.1, step = 0.1;

/// How far down the middle was hit.
static const double depth = 0.8;

/// A chain from (0, 0) to (1, 0), a little longer than that.
static void make_chain(tf_body *body)
{
    *body = (tf_body){.axes = 2};
    for (int v = 0; v < VERTICES; v++) {
        double x = (double)v / LINKS;
        tf_body_add_vertex(body, (const double[]){x, -0.6 * x * (1 - x)});
        if (v > 0)
            tf_body_add_spring(body, v - 1, v, stiffness);
        body->mass[v] = v > 0 && v < LINKS ? mass : 0;
    }
    TF_REQUIRE(!body->failed);
}

/// Where inertia leads.
static void hit(const tf_body *body, double end[NUMBERS])
{
    memcpy(end, body->position, sizeof(double) * NUMBERS);
    for (int v = 1; v < LINKS; v++) {
        double out = 2.0 * v / LINKS - 1;
        end[2 * v + 1] -= depth * exp(-9 * out * out);
    }
}

static double objective(const tf_body *body, const double inertia[],
                        const double end[])
{
    double sum = tf_body_elastic_energy(body, end);
    for (int i = 0; i < NUMBERS; i++)
        sum += body->mass[i / 2] / (2 * step * step) * (end[i] - inertia[i]) *
               (end[i] - inertia[i]);
    return sum;
}

/// The positions after a number of iterations.
static void iterate(const tf_body *body, const double inertia[], int iterations,
                    double end[NUMBERS])
{
    tf_dynamics *dynamics;
    memcpy(end, inertia, sizeof(double) * NUMBERS);
    TF_REQUIRE(tf_dynamics_create(body, step, &dynamics) == TF_OK);
    if (iterations > 0)
        TF_REQUIRE(tf_dynamics_step(dynamics, end, iterations) == TF_OK);
    tf_dynamics_free(dynamics);
}

// Drawing ---------------------------------------------------------------------

static void draw_chain(fig_page *page, const fig_plot *plot,
                       const double end[NUMBERS])
{
    fig_point at[VERTICES];
    for (int v = 0; v < VERTICES; v++)
        at[v] = (fig_point){end[(ptrdiff_t)2 * v], end[2 * v + 1]};
    fig_plot_curve(page, plot, VERTICES, at,
                   (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    for (int v = 0; v < VERTICES; v++)
        fig_plot_dot(page, plot, at[v].x, at[v].y, 4,
                     v % LINKS == 0 ? FIG_ROLE_INK : FIG_ROLE_EDGE);
}

/// The sum that each link wants, about the link's middle and beside it.
static void draw_wants(fig_page *page, const fig_plot *plot,
                       const tf_body *body, const double end[NUMBERS])
{
    for (int i = 0; i < body->elastics; i++) {
        double sum[3];
        tf_elastic_sum(&body->elastic[i], 2, end, sum);
        double length = hypot(sum[0], sum[1]);
        double part = body->elastic[i].rest / length / 2;
        const double *a = end + 2 * (ptrdiff_t)i;
        double x = a[0] + sum[0] / 2 - 0.035 * sum[1] / length;
        double y = a[1] + sum[1] / 2 + 0.035 * sum[0] / length;
        fig_plot_curve(
            page, plot, 2,
            (fig_point[]){{x - part * sum[0], y - part * sum[1]},
                          {x + part * sum[0], y + part * sum[1]}},
            (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT}, .arrow = true});
    }
}

static void draw_state(fig_page *page, int i, const tf_body *body,
                       const double end[NUMBERS], const char *title)
{
    fig_plot plot = {.box = {4 + 122.0 * i, 18, 116, 120},
                     .x = {-0.06, 1.06},
                     .y = {-1.05, 0.11}};
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_page_title(page, plot.box, title);
    draw_chain(page, &plot, end);
    if (i == 0)
        draw_wants(page, &plot, body, end);
}

static void draw_objective(fig_page *page, const double value[])
{
    fig_plot plot = {.box = {284, 18, 92, 102},
                     .x = {0, ITERATIONS},
                     .y = {0, 1.1 * value[0]},
                     .ticks_y = 3,
                     .ticks_x = 2,
                     .name_x = "iterations",
                     .name_y = "objective"};
    fig_point at[ITERATIONS + 1];
    for (int i = 0; i <= ITERATIONS; i++)
        at[i] = (fig_point){i, value[i]};
    fig_plot_frame(page, &plot);
    fig_plot_curve(page, &plot, ITERATIONS + 1, at,
                   (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    for (int i = 0; i <= ITERATIONS; i++)
        fig_plot_dot(page, &plot, at[i].x, at[i].y, 3.5, FIG_ROLE_EDGE);
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_body body;
    double inertia[NUMBERS], end[NUMBERS], value[ITERATIONS + 1];
    make_chain(&body);
    hit(&body, inertia);
    draw_state(page, 0, &body, inertia, "where inertia leads");
    for (int i = 0; i <= ITERATIONS; i++) {
        iterate(&body, inertia, i, end);
        value[i] = objective(&body, inertia, end);
        if (i == 1)
            draw_state(page, 1, &body, end, "one iteration");
    }
    draw_objective(page, value);
    fig_number(numbers, "iterations", ITERATIONS);
    fig_number(numbers, "before", value[0]);
    fig_number(numbers, "after_one", value[1]);
    fig_number(numbers, "after_all", value[ITERATIONS]);
    fig_number(numbers, "change_at_last",
               value[ITERATIONS - 1] - value[ITERATIONS]);
    tf_body_free(&body);
}

const fig_figure fig_local_global_step = {
    .name = "local-global-step",
    .title = "A chain before and after one iteration, and the objective",
    .width = FIG_PAGE_WIDTH,
    .height = 158,
    .draw = draw,
};
