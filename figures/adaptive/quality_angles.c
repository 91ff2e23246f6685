// The quality of triangles on a base, and its bounds by the least angle.
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdlib.h>

enum {
    COLUMNS = 120,
    ROWS = 90,
    SAMPLES = 121,
    BISECTIONS = 60
};

static const double fair = 0.6, straight = 0.5;

static double radians(double degrees)
{
    return degrees * acos(-1) / 180;
}

/// Of the triangle with the corners (0, 0), (1, 0) and (x, y).
static double quality_of(double x, double y)
{
    double squares = 1 + x * x + y * y + (1 - x) * (1 - x) + y * y;
    return 2 * sqrt(3) * fabs(y) / squares;
}

/// The least quality that a least angle allows, and the greatest.
static double low_bound(double degrees)
{
    double t = tan(radians(degrees));
    return sqrt(3) / (1.5 / t + 0.5 * t);
}

static double high_bound(double degrees)
{
    double a = radians(degrees);
    return sqrt(3) / (1 / tan(a) + 2 * tan(a / 2));
}

/// The angle at which a bound that grows has the value.
static double angle_at(double (*bound)(double degrees), double value)
{
    double low = 0.01, high = 60;
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = (low + high) / 2;
        if (bound(middle) < value)
            low = middle;
        else
            high = middle;
    }
    return high;
}

static void draw_map(fig_page *page, fig_box box)
{
    fig_rgb *cell = malloc(sizeof *cell * COLUMNS * ROWS);
    if (!cell)
        return;
    const fig_theme *theme = fig_page_theme(page);
    fig_rgb bad = fig_paint_color(theme, (fig_paint){.role = FIG_ROLE_CONTACT});
    fig_rgb good = fig_paint_color(theme, (fig_paint){.role = FIG_ROLE_EDGE});
    fig_rgb paper = fig_paint_color(theme, (fig_paint){.role = FIG_ROLE_PAPER});
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < COLUMNS; j++) {
            double x = -0.3 + 1.6 * (j + 0.5) / COLUMNS;
            double q = quality_of(x, 1.2 * (ROWS - i - 0.5) / ROWS);
            cell[i * COLUMNS + j] =
                q < fair ? fig_rgb_mix(bad, paper, q / fair)
                         : fig_rgb_mix(paper, good, (q - fair) / (1 - fair));
        }
    fig_page_map(page, box, COLUMNS, ROWS, cell);
    free(cell);
}

static void draw_base(fig_page *page, fig_box box)
{
    fig_plot plot = {.box = box, .x = {-0.3, 1.3}, .y = {0, 1.2}};
    fig_point corner[] = {{0, 0}, {1, 0}, {0.5, sqrt(0.75)}};
    fig_plot_curve(page, &plot, 3, corner,
                   (fig_stroke){.width = FIG_WIDTH_THIN, .closed = true});
    fig_plot_curve(page, &plot, 2, (fig_point[]){corner[0], {1, 0}},
                   (fig_stroke){.width = FIG_WIDTH_TUBE});
    fig_plot_curve(page, &plot, 2, (fig_point[]){{1, 0}, corner[2]},
                   (fig_stroke){.width = FIG_WIDTH_THIN});
    fig_plot_curve(page, &plot, 2, (fig_point[]){corner[2], {0, 0}},
                   (fig_stroke){.width = FIG_WIDTH_THIN});
}

static void draw_bound(fig_page *page, const fig_plot *plot,
                       double (*bound)(double degrees), fig_role role)
{
    fig_point at[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        double degrees = fmax(0.01, 60.0 * i / (SAMPLES - 1));
        at[i] = (fig_point){degrees, bound(degrees)};
    }
    fig_plot_curve(page, plot, SAMPLES, at,
                   (fig_stroke){.paint = {.role = role}});
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_box map = {8, 14, 160, 120};
    draw_map(page, map);
    draw_base(page, map);
    fig_plot plot = {.box = {226, 14, 146, 112},
                     .x = {0, 60},
                     .y = {0, 1},
                     .ticks_x = 4,
                     .ticks_y = 5,
                     .name_x = "least angle, degrees",
                     .name_y = "quality"};
    fig_plot_frame(page, &plot);
    fig_plot_curve(
        page, &plot, 2, (fig_point[]){{0, fair}, {60, fair}},
        (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL}, .dash = 3});
    draw_bound(page, &plot, low_bound, FIG_ROLE_EDGE);
    draw_bound(page, &plot, high_bound, FIG_ROLE_TRIANGLE);
    fig_number(numbers, "low", angle_at(high_bound, fair));
    fig_number(numbers, "high", angle_at(low_bound, fair));
    // Two unit vectors whose sum is `straight` long.
    fig_number(numbers, "turn", 2 * asin(straight / 2) * 180 / acos(-1));
}

const fig_figure fig_quality_angles = {
    .name = "quality-angles",
    .title = "Quality and the least angle",
    .width = FIG_PAGE_WIDTH,
    .height = 164,
    .draw = draw,
};
