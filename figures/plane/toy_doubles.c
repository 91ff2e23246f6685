// The numbers of a floating-point format with three bits, with and without
// subnormal numbers.
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>

enum {
    BITS = 3,
    LEAST = -4, ///< the exponent of the last bit of the smallest numbers
    MOST = -2,  ///< of the last bit of the largest below 2
    ROWS = 2
};

static const double row_y[ROWS] = {44, 104};

/// Two neighbours whose difference is subnormal.
static const double neighbor[2] = {0.25, 0.3125};

static void draw_tick(fig_page *page, const fig_plot *plot, double x, double y,
                      double height, fig_role role)
{
    double right = fig_plot_place(plot, x, 0).x;
    fig_page_line(
        page, 2, (fig_point[]){{right, y - height}, {right, y + height}},
        (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_LINE});
}

/// All numbers with an exponent, of full length or, in the lowest, shorter.
static int draw_binade(fig_page *page, const fig_plot *plot, double y,
                       int exponent, int first, fig_role role)
{
    int last = first < 1 << (BITS - 1) ? 1 << (BITS - 1) : 1 << BITS;
    for (int m = first; m < last; m++)
        draw_tick(page, plot, ldexp(m, exponent), y, 6, role);
    return last - first;
}

static void draw_scale(fig_page *page, const fig_plot *plot, double y)
{
    static const double at[] = {0, 0.25, 0.5, 1, 2};
    static const char *const name[] = {"$0$", "$1/4$", "$1/2$", "$1$", "$2$"};
    fig_point line[2] = {{fig_plot_place(plot, 0, 0).x, y},
                         {fig_plot_place(plot, 2, 0).x, y}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_THIN});
    for (int i = 0; i < 5; i++) {
        fig_point place = fig_plot_place(plot, at[i], 0);
        fig_page_text(page, place.x, y + 20, FIG_ALIGN_CENTER, name[i],
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
    draw_tick(page, plot, 0, y, 9, FIG_ROLE_INK);
    draw_tick(page, plot, 2, y, 9, FIG_ROLE_INK);
}

static void mark_neighbors(fig_page *page, const fig_plot *plot, double y)
{
    for (int i = 0; i < 2; i++) {
        fig_point place = fig_plot_place(plot, neighbor[i], 0);
        fig_page_dot(page, place.x, y, 5, (fig_paint){.role = FIG_ROLE_INK});
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const title[ROWS] = {"*with subnormal numbers*",
                                            "*without*"};
    double width = fig_page_width(page);
    fig_plot plot = {.box = {20, 0, width - 40, 10}, .x = {0, 2}, .y = {0, 1}};
    int normal = 0, subnormal = 0;
    for (int row = 0; row < ROWS; row++) {
        double y = row_y[row];
        draw_scale(page, &plot, y);
        normal = 0;
        for (int e = LEAST; e <= MOST; e++)
            normal +=
                draw_binade(page, &plot, y, e, 1 << (BITS - 1), FIG_ROLE_INK);
        if (row == 0)
            subnormal = draw_binade(page, &plot, y, LEAST, 1, FIG_ROLE_START);
        mark_neighbors(page, &plot, y);
        fig_page_text(page, width - 20, y - 16, FIG_ALIGN_RIGHT, title[row],
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
    fig_number(numbers, "normal", normal);
    fig_number(numbers, "subnormal", subnormal);
}

const fig_figure fig_toy_doubles = {
    .name = "toy-doubles",
    .title = "The numbers of a format with three bits",
    .width = FIG_PAGE_WIDTH,
    .height = 132,
    .draw = draw,
};
