#include "kit/bit_rows.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

enum {
    DOUBLE_BITS = 53
};

fig_box fig_bit_box(const fig_bit_rows *rows, int exponent, double y)
{
    return (fig_box){rows->left + (rows->highest - exponent) * rows->cell, y,
                     rows->cell - 0.6, rows->height};
}

/// The bit of |x| with the value 2^exponent.
static bool bit_of(double x, int exponent)
{
    return fmod(floor(ldexp(fabs(x), -exponent)), 2) == 1;
}

void fig_bits(fig_page *page, const fig_bit_rows *rows, double y, double x,
              fig_role role)
{
    for (int i = 0; i < DOUBLE_BITS; i++) {
        int exponent = ilogb(x) - i;
        double opacity = bit_of(x, exponent) ? 1 : 0.22;
        if (exponent >= rows->lowest)
            fig_page_fill_box(page, fig_bit_box(rows, exponent, y),
                              (fig_paint){.role = role, .opacity = opacity});
    }
}

void fig_bits_name(fig_page *page, const fig_bit_rows *rows, double y,
                   const char *name, fig_role role)
{
    fig_page_text(page, rows->left - 8, y + rows->height - 2, FIG_ALIGN_RIGHT,
                  name, FIG_LETTERS, role);
}

void fig_bits_scale(fig_page *page, const fig_bit_rows *rows, double y)
{
    for (int exponent = 0; exponent >= rows->lowest; exponent -= 10) {
        fig_box box = fig_bit_box(rows, exponent, y);
        double x = box.x + box.width / 2;
        char text[24];
        snprintf(text, sizeof text, "$2^{%d}$", exponent);
        fig_plot_tick(page, (fig_point){x, y}, text);
    }
}

void fig_bits_cut(fig_page *page, const fig_bit_rows *rows, int exponent,
                  double above, double below)
{
    double x = fig_bit_box(rows, exponent - 1, above).x - 0.3;
    fig_point line[2] = {{x, above}, {x, below}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.width = FIG_WIDTH_THIN, .dash = 3});
}
