// Two equal sheets that cross, seen from the side, and the two ways to pair their
// halves: how far the halves that are taken to be wrong have to turn.
#include "kit/figures.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    PANELS = 2,
    MOST_POINTS = 64
};

/// Of each sheet to the level, in degrees; the text speaks of less.
static const double slope = 12;

static fig_point point_at(double degrees, double radius)
{
    double angle = degrees * acos(-1) / 180;
    double x = radius * cos(angle), y = radius * sin(angle);
    return (fig_point){x, y};
}

/// Draws a half of a sheet, from the middle to its border.
static void draw_half(fig_page *page, const fig_plot *plot, double degrees,
                      fig_role role)
{
    fig_plot_curve(page, plot, 2, (fig_point[]){{0, 0}, point_at(degrees, 1)},
                   (fig_stroke){.paint = {.role = role}, .width = 2.4});
}

static void draw_turn(fig_page *page, const fig_plot *plot, double from,
                      double to, double radius)
{
    fig_point at[MOST_POINTS];
    int count = (int)(fabs(to - from) / 5) + 2; // each long enough for a head
    for (int i = 0; i < count; i++) {
        fig_point p = point_at(from + (to - from) * i / (count - 1), radius);
        at[i] = fig_plot_place(plot, p.x, p.y);
    }
    fig_page_line(page, count, at, (fig_stroke){.arrow = true});
}

static fig_plot panel(fig_page *page, int i, const char *title)
{
    double width = fig_page_width(page) / PANELS;
    fig_plot plot = {.box = {width * i + 14, 18, width - 28, 88},
                     .x = {-1.1, 1.1},
                     .y = {-0.28, -0.28 + 2.2 * 88 / (width - 28)}};
    fig_page_title(page, plot.box, title);
    return plot;
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot well = panel(page, 0, "paired well");
    draw_half(page, &well, 180 - slope, FIG_ROLE_TRIANGLE);
    draw_half(page, &well, 180 + slope, FIG_ROLE_EDGE);
    draw_half(page, &well, slope, FIG_ROLE_POINT);
    draw_half(page, &well, -slope, FIG_ROLE_POINT);
    draw_turn(page, &well, slope + 2, -slope - 9, 0.9);
    draw_turn(page, &well, -slope - 2, slope + 9, 0.72);
    fig_plot badly = panel(page, 1, "paired badly");
    draw_half(page, &badly, -slope, FIG_ROLE_TRIANGLE);
    draw_half(page, &badly, 180 + slope, FIG_ROLE_EDGE);
    draw_half(page, &badly, slope, FIG_ROLE_POINT);
    draw_half(page, &badly, 180 - slope, FIG_ROLE_POINT);
    draw_turn(page, &badly, slope + 3, 180 - slope + 5, 0.9);
    draw_turn(page, &badly, 180 - slope - 3, slope - 5, 0.7);
    fig_number(numbers, "well", 2 * slope);
    fig_number(numbers, "badly", 180 - 2 * slope);
}

const fig_figure fig_paired_halves = {
    .name = "paired-halves",
    .title = "Two ways to pair the halves of sheets",
    .width = FIG_PAGE_WIDTH,
    .height = 112,
    .draw = draw,
};
