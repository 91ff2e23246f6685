// How far a sheet without springs slides down a slope in a second, by the angle
// of the slope, and what mechanics says.
#include "kit/falling.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

enum {
    FRICTIONS = 4,
    ANGLES = 24, ///< 2 degrees and more, by as much
    CURVE = 225
};

static const double each_angle = 2, step = 0.0025, right_angle = 90;

static const double friction[FRICTIONS] = {0.2, 0.4, 0.6, 0.8};

static const fig_role role[FRICTIONS] = {FIG_ROLE_CONTACT, FIG_ROLE_TRIANGLE,
                                         FIG_ROLE_POINT, FIG_ROLE_EDGE};

static double radians(double degrees)
{
    return degrees / right_angle * acos(0);
}

/// What a body is accelerated by; 0 if it sticks.
static double acceleration(double degrees, double mu)
{
    double a = radians(degrees);
    return FIG_GRAVITY * fmax(0, sin(a) - mu * cos(a));
}

// Slopes ----------------------------------------------------------------------

/// A point of the slope's own axes: down, across, and off the slope.
static int add(fig_falling *slope, double degrees, const double at[3],
               bool stays)
{
    double s = sin(radians(degrees)), c = cos(radians(degrees));
    return fig_falling_vertex(
        slope, (double[]){at[0] * c + at[2] * s, at[1], at[2] * c - at[0] * s},
        stays);
}

/// Two triangles, and four vertices above them, so near that they have contacts
/// in the first step.
static fig_falling slope_of(double degrees, double mu)
{
    static const int corner[] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    double off = 0.25 * FIG_GRAVITY * cos(radians(degrees)) * step * step;
    fig_falling slope = {.axes = 3, .triangles = 4, .step = step};
    slope.options.separation = 0.01;
    slope.options.friction = mu;
    for (int i = 0; i < 12; i++)
        slope.triangle[i] = corner[i];
    for (int i = 0; i < 4; i++)
        add(&slope, degrees,
            (double[]){i % 3 == 0 ? -1 : 10, i < 2 ? -3 : 3, 0}, true);
    for (int i = 0; i < 4; i++)
        add(&slope, degrees,
            (double[]){i % 3 == 0 ? 0 : 0.1, i < 2 ? 0.013 : 0.113, off},
            false);
    return slope;
}

static double way_down(const fig_falling *slope, double degrees)
{
    double sum = 0;
    for (int v = 4; v < slope->vertices; v++) {
        const double *x = slope->position + 3 * (ptrdiff_t)v;
        sum += x[0] * cos(radians(degrees)) - x[2] * sin(radians(degrees));
    }
    return sum / (slope->vertices - 4);
}

/// How far the sheet slides in a second.
static double slide(double degrees, double mu)
{
    fig_falling slope = slope_of(degrees, mu);
    double from = way_down(&slope, degrees);
    fig_falling_begin(&slope);
    for (int i = 0; i < (int)lround(1 / step); i++)
        fig_falling_step(&slope);
    double way = way_down(&slope, degrees) - from;
    fig_falling_finish(&slope);
    return way;
}

// Drawing ---------------------------------------------------------------------

/// How wrong the slides are: those of sheets that should stick in micrometers,
/// others in parts of what they should be.
typedef struct errors {
    double stuck, slid;
    int sticking, sliding;
} errors;

static void compare(errors *e, double way, double expected)
{
    if (expected == 0) {
        e->stuck = fmax(e->stuck, 1e6 * fabs(way));
        e->sticking++;
    } else {
        e->slid = fmax(e->slid, fabs(way / expected - 1));
        e->sliding++;
    }
}

static void draw_friction(fig_page *page, const fig_plot *plot, int i,
                          errors *e, FILE *numbers)
{
    fig_point at[CURVE];
    for (int k = 0; k < CURVE; k++) {
        double degrees = k * plot->x[1] / (CURVE - 1);
        at[k] = (fig_point){degrees, acceleration(degrees, friction[i]) / 2};
    }
    fig_plot_curve(page, plot, CURVE, at,
                   (fig_stroke){.paint = {.role = role[i]}});
    // Each step accelerates before it moves.
    double steps = round(1 / step);
    for (int k = 1; k <= ANGLES; k++) {
        double degrees = k * each_angle, way = slide(degrees, friction[i]);
        double expected = acceleration(degrees, friction[i]) / 2;
        compare(e, way, expected * (1 + 1 / steps));
        fig_plot_dot(page, plot, degrees, way, 4, role[i]);
    }
    char key[32], text[32];
    fig_point end = fig_plot_place(plot, at[CURVE - 1].x, at[CURVE - 1].y);
    snprintf(text, sizeof text, "$μ = %g$", friction[i]);
    fig_page_text(page, end.x + 5, end.y + 3, FIG_ALIGN_LEFT, text, FIG_LETTERS,
                  role[i]);
    snprintf(key, sizeof key, "slid_%g", friction[i]);
    fig_number(numbers, key, slide(30, friction[i]));
}

/// A slope, what lies on it, and where gravity and the slope draw it.
static void draw_sketch(fig_page *page)
{
    const double degrees = 24, width = 120;
    double s = sin(radians(degrees)), c = cos(radians(degrees));
    fig_point low = {178, 88}, high = {178 - width, 88 - width * s / c};
    fig_point wedge[] = {low, high, {high.x, low.y}};
    fig_point middle = {low.x - 0.6 * width, low.y - 0.6 * width * s / c - 3};
    fig_page_fill(page, 3, wedge,
                  (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.2});
    fig_page_line(page, 2, (fig_point[]){low, high}, (fig_stroke){0});
    fig_page_line(page, 2,
                  (fig_point[]){{middle.x - 17 * c, middle.y - 17 * s},
                                {middle.x + 17 * c, middle.y + 17 * s}},
                  (fig_stroke){.width = 4});
    fig_page_line(page, 2, (fig_point[]){middle, {middle.x, middle.y + 34}},
                  (fig_stroke){.arrow = true});
    fig_page_arc(page, low.x, low.y, 56, 180 - degrees, 180, (fig_stroke){0});
    fig_page_text(page, low.x - 40, low.y - 4, FIG_ALIGN_CENTER, "$α$",
                  FIG_LETTERS, FIG_ROLE_INK);
    fig_page_text(page, middle.x - 5, middle.y + 31, FIG_ALIGN_RIGHT, "$g$",
                  FIG_LETTERS, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    errors e = {0};
    fig_plot plot = {.box = {36, 10, 296, 170},
                     .x = {0, 50},
                     .y = {0, 3.3},
                     .ticks_x = 6,
                     .ticks_y = 4,
                     .name_x = "slope $α$, degrees",
                     .name_y = "slid in a second, m"};
    fig_plot_frame(page, &plot);
    // What sticks lies at zero: on top is the least friction that holds it.
    for (int i = FRICTIONS - 1; i >= 0; i--)
        draw_friction(page, &plot, i, &e, numbers);
    draw_sketch(page);
    fig_number(numbers, "micrometers_stuck", e.stuck);
    fig_number(numbers, "error_slid", e.slid);
    fig_number(numbers, "parts_per_trillion", ceil(1e12 * e.slid));
    fig_number(numbers, "sticking", e.sticking);
    fig_number(numbers, "sliding", e.sliding);
}

const fig_figure fig_slopes = {
    .name = "slopes",
    .title = "How far sheets slide down slopes",
    .width = FIG_PAGE_WIDTH,
    .height = 214,
    .draw = draw,
};
