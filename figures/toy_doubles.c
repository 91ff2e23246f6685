// The numbers of a floating-point format with three bits, with and without
// subnormal numbers.
#include "figures.h"

#include "stage/plot.h"

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

static void draw_tick(tf_page *page, const tf_plot *plot, double x, double y,
                      double height, tf_role role)
{
    double at[2][2];
    tf_plot_place(plot, x, 0, at[0]);
    tf_plot_place(plot, x, 0, at[1]);
    at[0][1] = y - height;
    at[1][1] = y + height;
    tf_page_line(page, 2, (const double(*)[2])at,
                 (tf_stroke){.paint = {.role = role}, .width = TF_WIDTH_LINE});
}

/// All numbers with an exponent, of full length or, in the lowest, shorter.
static int draw_binade(tf_page *page, const tf_plot *plot, double y,
                       int exponent, int first, tf_role role)
{
    int last = first < 1 << (BITS - 1) ? 1 << (BITS - 1) : 1 << BITS;
    for (int m = first; m < last; m++)
        draw_tick(page, plot, ldexp(m, exponent), y, 6, role);
    return last - first;
}

static void draw_scale(tf_page *page, const tf_plot *plot, double y)
{
    static const double at[] = {0, 0.25, 0.5, 1, 2};
    static const char *const name[] = {"$0$", "$1/4$", "$1/2$", "$1$", "$2$"};
    double line[2][2];
    tf_plot_place(plot, 0, 0, line[0]);
    tf_plot_place(plot, 2, 0, line[1]);
    line[0][1] = line[1][1] = y;
    tf_page_line(page, 2, (const double(*)[2])line,
                 (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                             .width = TF_WIDTH_THIN});
    for (int i = 0; i < 5; i++) {
        double place[2];
        tf_plot_place(plot, at[i], 0, place);
        tf_page_text(page, place[0], y + 20, TF_ALIGN_CENTER, name[i],
                     TF_LETTERS_SMALL, TF_ROLE_INK);
    }
    draw_tick(page, plot, 0, y, 9, TF_ROLE_INK);
    draw_tick(page, plot, 2, y, 9, TF_ROLE_INK);
}

static void mark_neighbors(tf_page *page, const tf_plot *plot, double y)
{
    for (int i = 0; i < 2; i++) {
        double place[2];
        tf_plot_place(plot, neighbor[i], 0, place);
        tf_page_dot(page, place[0], y, 5, (tf_paint){.role = TF_ROLE_CONTACT});
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    static const char *const title[ROWS] = {"*with subnormal numbers*",
                                            "*without*"};
    double width = tf_page_width(page);
    tf_plot plot = {.box = {20, 0, width - 40, 10}, .x = {0, 2}, .y = {0, 1}};
    int normal = 0, subnormal = 0;
    for (int row = 0; row < ROWS; row++) {
        double y = row_y[row];
        draw_scale(page, &plot, y);
        normal = 0;
        for (int e = LEAST; e <= MOST; e++)
            normal +=
                draw_binade(page, &plot, y, e, 1 << (BITS - 1), TF_ROLE_INK);
        if (row == 0)
            subnormal = draw_binade(page, &plot, y, LEAST, 1, TF_ROLE_START);
        mark_neighbors(page, &plot, y);
        tf_page_text(page, width - 20, y - 16, TF_ALIGN_RIGHT, title[row],
                     TF_LETTERS_SMALL, TF_ROLE_INK);
    }
    tf_figure_number(numbers, "normal", normal);
    tf_figure_number(numbers, "subnormal", subnormal);
}

const tf_figure tf_figure_toy_doubles = {
    .name = "toy-doubles",
    .title = "The numbers of a format with three bits",
    .width = TF_FIGURE_WIDTH,
    .height = 132,
    .draw = draw,
};
