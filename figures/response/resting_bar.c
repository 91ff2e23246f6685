// A bar that is let go just above a floor, in steps of four lengths: as pushes
// that become velocities throw it, and as it comes to rest.
#include "kit/falling.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    STEPS = 4,
    SHOWN = 2000, ///< points of a curve
    APEXES = 3
};

static const double release = 0.0002, separation = 0.005;

/// Milliseconds.
static const double length_of_step[STEPS] = {0.25, 1, 2.5, 10};

static const fig_role role[STEPS] = {FIG_ROLE_CONTACT, FIG_ROLE_TRIANGLE,
                                     FIG_ROLE_POINT, FIG_ROLE_EDGE};

/// A floor, and a bar of 10 cm above it.
static fig_falling bar_at(double height, double step)
{
    fig_falling bar = {.axes = 2,
                       .edges = 2,
                       .edge = {0, 1, 2, 3},
                       .step = step,
                       .options.separation = separation};
    fig_falling_vertex(&bar, (double[]){-1, 0}, true);
    fig_falling_vertex(&bar, (double[]){1, 0}, true);
    fig_falling_vertex(&bar, (double[]){-0.05, height}, false);
    fig_falling_vertex(&bar, (double[]){0.05, height}, false);
    return bar;
}

static double height_of(const fig_falling *bar)
{
    return fmax(bar->position[5], bar->position[7]);
}

/// How high a hop goes, if it takes so many steps that they are no matter:
/// millimeters.
static double highest_hop(double step)
{
    double speed = separation / (4 * step), time = 2 * speed / FIG_GRAVITY;
    return time < 10 * step ? 0 : 1000 * speed * speed / (2 * FIG_GRAVITY);
}

/// Half of what gravity draws in a step: millimeters.
static double half_of_approach(double step)
{
    return 1000 * FIG_GRAVITY * step * step / 2;
}

static void print(FILE *numbers, const char *what, const char *panel, int i,
                  double value)
{
    char key[48];
    snprintf(key, sizeof key, "%s_%s_%g", what, panel, length_of_step[i]);
    fig_number(numbers, key, value);
}

/// A second of a bar in steps of the i-th length.
static void draw_second(fig_page *page, const fig_plot *plot, bool hops, int i,
                        FILE *numbers)
{
    double step = length_of_step[i] / 1000, most = 0;
    int steps = (int)lround(1 / step), each = (steps + SHOWN - 1) / SHOWN;
    fig_point at[SHOWN + 1];
    int points = 0;
    fig_falling bar = bar_at(release, step);
    bar.hops = hops;
    fig_falling_begin(&bar);
    for (int n = 0; n <= steps; n++) {
        double height = 1000 * height_of(&bar);
        most = fmax(most, height);
        if (n % each == 0)
            at[points++] = (fig_point){n * step, height};
        if (n < steps)
            fig_falling_step(&bar);
    }
    fig_plot_curve(page, plot, points, at,
                   (fig_stroke){.paint = {.role = role[i]}});
    const char *panel = hops ? "hops" : "rests";
    print(numbers, "most", panel, i, most);
    print(numbers, "last", panel, i, 1000 * height_of(&bar));
    print(numbers, "speed", panel, i, fabs(bar.velocity[5]));
    if (!hops && i == 0)
        fig_number(numbers, "nanometers", 1e9 * height_of(&bar));
    fig_falling_finish(&bar);
}

/// What theory says of all steps: a dashed line for each.
static void draw_theory(fig_page *page, const fig_plot *plot,
                        double (*theory)(double step))
{
    for (int i = 0; i < STEPS; i++) {
        double y = theory(length_of_step[i] / 1000);
        if (y >= plot->y[0])
            fig_plot_curve(page, plot, 2, (fig_point[]){{0, y}, {1, y}},
                           (fig_stroke){.paint = {.role = role[i]},
                                        .width = FIG_WIDTH_THIN,
                                        .dash = 3});
    }
}

static void draw_panel(fig_page *page, const fig_plot *plot, bool hops,
                       FILE *numbers)
{
    fig_plot_frame(page, plot);
    for (int i = 0; i < STEPS; i++)
        draw_second(page, plot, hops, i, numbers);
    draw_theory(page, plot, hops ? highest_hop : half_of_approach);
    fig_page_title(page, plot->box,
                   hops ? "velocity with the push" : "velocity without it");
}

/// How high a bar rises that falls from half a meter with a restitution of one
/// half.
static void print_bounces(FILE *numbers)
{
    fig_falling bar = bar_at(0.5, 0.001);
    double last = 0.5;
    bool rises = false;
    bar.options.restitution = 0.5;
    fig_falling_begin(&bar);
    for (int found = 0; found < APEXES;) {
        fig_falling_step(&bar);
        double height = height_of(&bar);
        char key[16];
        snprintf(key, sizeof key, "apex_%d", found + 1);
        if (rises && height < last) {
            fig_number(numbers, key, 1000 * last);
            found++;
        }
        rises = height > last;
        last = height;
    }
    fig_falling_finish(&bar);
}

static void draw_keys(fig_page *page)
{
    for (int i = 0; i < STEPS; i++) {
        char text[16];
        snprintf(text, sizeof text, "%g ms", length_of_step[i]);
        fig_plot_key(page, 80 + 68.0 * i, 206, text, role[i]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {46, 20, 150, 148},
                     .x = {0, 1},
                     .y = {0.0001, 10000},
                     .log_y = true,
                     .name_x = "time, s",
                     .name_y = "height, mm"};
    draw_panel(page, &plot, true, numbers);
    plot.box.x += 182;
    plot.name_y = NULL;
    draw_panel(page, &plot, false, numbers);
    draw_keys(page);
    fig_number(numbers, "release", 1000 * release);
    fig_number(numbers, "separation", 1000 * separation);
    print_bounces(numbers);
}

const fig_figure fig_resting_bar = {
    .name = "resting-bar",
    .title = "A bar that is let go just above a floor",
    .width = FIG_PAGE_WIDTH,
    .height = 214,
    .draw = draw,
};
