// Errors of Enright's test against the length of edges.
#include "kit/figures.h"
#include "kit/measured.h"

#include "renderer/plot.h"

#include <math.h>

static const int starts[] = {320, 1280, 5120, 6480}; ///< triangles

enum {
    STARTS = sizeof starts / sizeof *starts
};

static const double radius = 0.15;

static double edge_of(int start)
{
    return fig_measured("flowing %d edge", start);
}

/// "rms" or "max", as a length.
static double error_of(int start, const char *which)
{
    return fig_measured("flowing %d %s", start, which) / 1000;
}

static void draw_dots(fig_page *page, const fig_plot *plot, const char *which,
                      fig_role role)
{
    for (int i = 0; i < STARTS; i++)
        fig_plot_dot(page, plot, edge_of(starts[i]), error_of(starts[i], which),
                     6, role);
}

/// Nearly a decade is too short for its powers of 10.
static void draw_ticks(fig_page *page, const fig_plot *plot)
{
    static const struct {
        double at;
        const char *name;
    } ticks[] = {{0.01, "0.01"}, {0.02, "0.02"}, {0.04, "0.04"}};
    for (size_t i = 0; i < sizeof ticks / sizeof *ticks; i++)
        fig_plot_tick(page, fig_plot_place(plot, ticks[i].at, plot->y[0]),
                      ticks[i].name);
}

/// A name at the right end of a line, dy points down from there.
static void draw_name(fig_page *page, const fig_plot *plot, fig_point end,
                      double dy, const char *name)
{
    fig_point at = fig_plot_place(plot, end.x, end.y);
    fig_page_text(page, at.x, at.y + dy, FIG_ALIGN_RIGHT, name,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

/// The line of slope 2 through the mean error of 5,120 triangles.
static void draw_slope(fig_page *page, const fig_plot *plot)
{
    double factor = error_of(5120, "rms") / pow(edge_of(5120), 2);
    fig_point line[2];
    for (int i = 0; i < 2; i++)
        line[i] = (fig_point){plot->x[i], factor * pow(plot->x[i], 2)};
    fig_plot_curve(
        page, plot, 2, line,
        (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL}, .dash = 4});
    draw_name(page, plot, line[1], 18, "slope 2");
}

static void draw_radius(fig_page *page, const fig_plot *plot)
{
    fig_point line[2] = {{plot->x[0], radius}, {plot->x[1], radius}};
    fig_plot_curve(page, plot, 2, line,
                   (fig_stroke){.paint = {.role = FIG_ROLE_INK}, .dash = 1.5});
    draw_name(page, plot, line[1], -6, "radius");
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {60, 10, 300, 150},
                     .x = {0.008, 0.06},
                     .y = {1e-4, 0.3},
                     .log_x = true,
                     .log_y = true,
                     .ticks_x = -1,
                     .name_y = "distance from the sphere"};
    fig_plot_frame(page, &plot);
    draw_ticks(page, &plot);
    fig_page_text(page, plot.box.x + plot.box.width / 2, 194, FIG_ALIGN_CENTER,
                  "length $L$ of edges", FIG_LETTERS, FIG_ROLE_INK);
    draw_radius(page, &plot);
    draw_slope(page, &plot);
    draw_dots(page, &plot, "max", FIG_ROLE_OTHER_EDGE);
    draw_dots(page, &plot, "rms", FIG_ROLE_EDGE);
    fig_plot_key(page, 72, 44, "largest", FIG_ROLE_OTHER_EDGE);
    fig_plot_key(page, 72, 60, "mean", FIG_ROLE_EDGE);
    fig_number(numbers, "slope",
               log(error_of(1280, "rms") / error_of(5120, "rms")) /
                   log(edge_of(1280) / edge_of(5120)));
}

const fig_figure fig_enright_error = {
    .name = "enright-error",
    .title = "The error of Enright's test",
    .width = FIG_PAGE_WIDTH,
    .height = 200,
    .draw = draw,
};
