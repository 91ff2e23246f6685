// The sum of two doubles as two doubles, bit by bit.
#include "figures.h"

#include "arithmetic/two_sum.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdint.h>

enum {
    HIGHEST = 3,
    LOWEST = -75, // the last place of b
    DOUBLE_BITS = 53
};

static const double left = 52, cell = 3.9, height = 11;

/// pi, and e / 2^24, as doubles.
static const double a = 0x1.921fb54442d18p+1, b = 0x1.5bf0a8b145769p-23;

static fig_box bit_box(int exponent, double y)
{
    return (fig_box){left + (HIGHEST - exponent) * cell, y, cell - 0.6, height};
}

/// The bit of |x| with the value 2^exponent.
static bool bit_of(double x, int exponent)
{
    return fmod(floor(ldexp(fabs(x), -exponent)), 2) == 1;
}

/// The places of a double: ones full, zeros pale, and nothing beyond.
static void draw_bits(fig_page *page, double y, double x, fig_role role)
{
    for (int i = 0; i < DOUBLE_BITS; i++) {
        int exponent = ilogb(x) - i;
        double opacity = bit_of(x, exponent) ? 1 : 0.22;
        if (exponent >= LOWEST)
            fig_page_fill_box(page, bit_box(exponent, y),
                              (fig_paint){.role = role, .opacity = opacity});
    }
}

static void name_row(fig_page *page, double y, const char *name, fig_role role)
{
    fig_page_text(page, left - 8, y + height - 2, FIG_ALIGN_RIGHT, name,
                  FIG_LETTERS, role);
}

/// Powers of two below all rows.
static void draw_scale(fig_page *page, double y)
{
    for (int exponent = 0; exponent >= LOWEST; exponent -= 10) {
        fig_box box = bit_box(exponent, y);
        double x = box.x + box.width / 2;
        char text[24];
        snprintf(text, sizeof text, "$2^{%d}$", exponent);
        fig_plot_tick(page, (fig_point){x, y}, text);
    }
}

/// Where the last place of `hi` ends.
static void draw_cut(fig_page *page, double hi, double above, double below)
{
    fig_box box = bit_box(ilogb(hi) - DOUBLE_BITS, above);
    double x = box.x - 0.3;
    fig_point line[2] = {{x, above}, {x, below}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.width = FIG_WIDTH_THIN, .dash = 3});
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_two sum = tf_two_sum(a, b);
    const double row[] = {8, 26, 56, 74};
    name_row(page, row[0], "$a$", FIG_ROLE_EDGE);
    draw_bits(page, row[0], a, FIG_ROLE_EDGE);
    name_row(page, row[1], "$b$", FIG_ROLE_POINT);
    draw_bits(page, row[1], b, FIG_ROLE_POINT);
    name_row(page, row[2], "hi", FIG_ROLE_INK);
    draw_bits(page, row[2], sum.hi, FIG_ROLE_INK);
    name_row(page, row[3], sum.lo < 0 ? "−lo" : "lo", FIG_ROLE_INK);
    draw_bits(page, row[3], sum.lo, FIG_ROLE_INK);
    draw_cut(page, sum.hi, row[0] - 4, row[3] + height + 4);
    draw_scale(page, row[3] + height + 6);
    fig_number(numbers, "hi", sum.hi);
    fig_number(numbers, "lo", sum.lo);
    fig_number(numbers, "hi_last", ilogb(sum.hi) - DOUBLE_BITS + 1);
    fig_number(numbers, "lo_first", ilogb(sum.lo));
}

const fig_figure fig_two_sum = {
    .name = "two-sum",
    .title = "The sum of two doubles as two doubles, bit by bit",
    .width = FIG_PAGE_WIDTH,
    .height = 116,
    .draw = draw,
};
