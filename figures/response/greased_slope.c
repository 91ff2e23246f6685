// Particles with coefficients of friction of their own on a slope that is greased
// above and rough below: their speeds, and what mechanics says.
#include "kit/falling.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

enum {
    PARTICLES = 4,
    ROWS = 4,    ///< of two vertices each, down the slope
    SHADES = 40, ///< between the two
    CURVE = 400,
    MOST_STEPS = 5000,
    BETWEEN = 60 ///< steps from dot to dot
};

static const double step = 0.001, degrees = 25, right_angle = 90;

/// Where the rows of the slope are, down from where the particles start, and
/// their coefficients.
static const double row[ROWS] = {-1, 1, 2, 8};
static const double rough[ROWS] = {0, 0, 1, 1};

static const double friction[PARTICLES] = {0, 0.16, 0.5, 1};

static const fig_role role[PARTICLES] = {FIG_ROLE_INK, FIG_ROLE_TRIANGLE,
                                         FIG_ROLE_POINT, FIG_ROLE_EDGE};

static double angle(void)
{
    return degrees / right_angle * acos(0);
}

// Mechanics -------------------------------------------------------------------

/// The coefficient of the slope at a distance from the start.
static double rough_at(double x)
{
    return fmin(fmax((x - row[1]) / (row[2] - row[1]), 0), 1);
}

/// The square of the speed there: twice the work of gravity, less that of
/// friction, which is proportional to the root of the slope's coefficient.
static double square_of_speed(double x, double mu)
{
    double part = rough_at(x), beyond = fmax(x - row[2], 0);
    double root = part * sqrt(part) * 2 / 3 + beyond;
    return 2 * FIG_GRAVITY *
           (x * sin(angle()) - sqrt(mu) * root * cos(angle()));
}

// Slopes ----------------------------------------------------------------------

/// A point of the slope's own axes: down, across, and off the slope.
static void add(fig_falling *slope, const double at[3], bool stays)
{
    double s = sin(angle()), c = cos(angle());
    fig_falling_vertex(
        slope, (double[]){at[0] * c + at[2] * s, at[1], at[2] * c - at[0] * s},
        stays);
}

static void add_triangle(fig_falling *slope, int a, int b, int c)
{
    int *corner = slope->triangle + 3 * (ptrdiff_t)slope->triangles++;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

/// The particles start so near that they have contacts in the first step.
static void make_slope(fig_falling *slope, double coefficient[])
{
    double off = 0.25 * FIG_GRAVITY * cos(angle()) * step * step;
    *slope = (fig_falling){.axes = 3, .step = step};
    slope->options.separation = 0.01;
    slope->options.vertex_friction = coefficient;
    for (int i = 0; i < 2 * ROWS; i++) {
        add(slope, (double[]){row[i / 2], i % 2 == 0 ? -1 : 1, 0}, true);
        coefficient[i] = rough[i / 2];
    }
    for (int i = 0; i < 2 * (ROWS - 1); i++)
        add_triangle(slope, i, i % 2 == 0 ? i + 1 : i + 2,
                     i % 2 == 0 ? i + 2 : i + 1);
    for (int i = 0; i < PARTICLES; i++) {
        coefficient[slope->vertices] = friction[i];
        add(slope, (double[]){0, 0.15 * i - 0.2, off}, false);
    }
}

/// How far down a particle is, and how fast it goes there.
static fig_point way_of(const fig_falling *slope, int i)
{
    ptrdiff_t at = (ptrdiff_t)3 * (2 * ROWS + i);
    const double *x = slope->position + at, *v = slope->velocity + at;
    double s = sin(angle()), c = cos(angle());
    return (fig_point){x[0] * c - x[2] * s, v[0] * c - v[2] * s};
}

// Drawing ---------------------------------------------------------------------

static void shade(fig_page *page, const fig_plot *plot, double from, double to,
                  double opacity)
{
    fig_point low = fig_plot_place(plot, from, plot->y[0]);
    fig_point high = fig_plot_place(plot, to, plot->y[1]);
    fig_page_fill_box(
        page, (fig_box){low.x, high.y, high.x - low.x, low.y - high.y},
        (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = opacity});
}

/// The rougher, the darker.
static void draw_slope(fig_page *page, const fig_plot *plot)
{
    const double most = 0.3;
    for (int i = 0; i < SHADES; i++) {
        double from = row[1] + (row[2] - row[1]) * i / SHADES;
        double to = row[1] + (row[2] - row[1]) * (i + 1) / SHADES;
        shade(page, plot, from, to, most * rough_at((from + to) / 2));
    }
    shade(page, plot, row[2], plot->x[1], most);
    fig_point at = fig_plot_place(plot, 0.12, 5.5);
    fig_page_text(page, at.x, at.y, FIG_ALIGN_LEFT, "greased", FIG_LETTERS,
                  FIG_ROLE_INK);
    at = fig_plot_place(plot, 2.08, 5.5);
    fig_page_text(page, at.x, at.y, FIG_ALIGN_LEFT, "rough", FIG_LETTERS,
                  FIG_ROLE_INK);
}

static void draw_theory(fig_page *page, const fig_plot *plot, int i)
{
    fig_point at[CURVE];
    int count = 0;
    for (int k = 0; k < CURVE; k++) {
        double x = plot->x[1] * k / (CURVE - 1);
        double square = square_of_speed(x, friction[i]);
        at[count++] = (fig_point){x, sqrt(fmax(square, 0))};
        if (square < 0)
            break;
    }
    fig_plot_curve(page, plot, count, at,
                   (fig_stroke){.paint = {.role = role[i]}});
}

static void name(fig_page *page, const fig_plot *plot, int i)
{
    // Each name is beside the end of its curve.
    static const fig_point at[PARTICLES] = {
        {4.06, 5.66}, {4.06, 3.7}, {4.06, 0.35}, {2.57, 0.35}};
    fig_point to = fig_plot_place(plot, at[i].x, at[i].y);
    char text[32];
    snprintf(text, sizeof text, "$μ = %g$", friction[i]);
    fig_page_text(page, to.x, to.y, FIG_ALIGN_LEFT, text, FIG_LETTERS, role[i]);
}

/// Lets the particles slide, and draws a dot now and then; returns by how much
/// the square of a speed differs from that of theory at most.
static double slide(fig_page *page, const fig_plot *plot, double stopped[])
{
    fig_falling slope;
    double coefficient[FIG_FALLING_MOST], error = 0;
    make_slope(&slope, coefficient);
    fig_falling_begin(&slope);
    for (int n = 0; n < MOST_STEPS; n++) {
        fig_falling_step(&slope);
        for (int i = 0; i < PARTICLES; i++) {
            fig_point at = way_of(&slope, i);
            if (at.x > plot->x[1])
                continue;
            stopped[i] = at.x;
            double square = at.y * at.y;
            error =
                fmax(error, fabs(square - square_of_speed(at.x, friction[i])));
            if (n % BETWEEN == 0 && at.y > 0)
                fig_plot_dot(page, plot, at.x, at.y, 4, role[i]);
        }
        if (way_of(&slope, 1).x > plot->x[1] && way_of(&slope, 2).y == 0 &&
            way_of(&slope, 3).y == 0)
            break;
    }
    fig_falling_finish(&slope);
    return error;
}

static void draw(fig_page *page, FILE *numbers)
{
    double stopped[PARTICLES] = {0};
    fig_plot plot = {.box = {36, 10, 286, 150},
                     .x = {0, 4},
                     .y = {0, 6},
                     .ticks_x = 5,
                     .ticks_y = 4,
                     .name_x = "distance down the slope, m",
                     .name_y = "speed, m/s"};
    draw_slope(page, &plot);
    fig_plot_frame(page, &plot);
    for (int i = 0; i < PARTICLES; i++) {
        draw_theory(page, &plot, i);
        name(page, &plot, i);
    }
    fig_number(numbers, "error", slide(page, &plot, stopped));
    fig_number(numbers, "stopped_0.5", stopped[2]);
    fig_number(numbers, "stopped_1", stopped[3]);
    fig_number(numbers, "degrees", degrees);
}

const fig_figure fig_greased_slope = {
    .name = "greased-slope",
    .title = "Particles on a slope that is greased above and rough below",
    .width = FIG_PAGE_WIDTH,
    .height = 194,
    .draw = draw,
};
