// The sum of two doubles as two doubles, bit by bit.
#include "figures.h"

#include "arithmetic/two_sum.h"

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

static tf_box bit_box(int exponent, double y)
{
    return (tf_box){left + (HIGHEST - exponent) * cell, y, cell - 0.6, height};
}

/// The bit of |x| with the value 2^exponent.
static bool bit_of(double x, int exponent)
{
    return fmod(floor(ldexp(fabs(x), -exponent)), 2) == 1;
}

/// The places of a double: ones full, zeros pale, and nothing beyond.
static void draw_bits(tf_page *page, double y, double x, tf_role role)
{
    for (int i = 0; i < DOUBLE_BITS; i++) {
        int exponent = ilogb(x) - i;
        double opacity = bit_of(x, exponent) ? 1 : 0.22;
        if (exponent >= LOWEST)
            tf_page_fill_box(page, bit_box(exponent, y),
                             (tf_paint){.role = role, .opacity = opacity});
    }
}

static void name_row(tf_page *page, double y, const char *name, tf_role role)
{
    tf_page_text(page, left - 8, y + height - 2, TF_ALIGN_RIGHT, name,
                 TF_LETTERS, role);
}

/// Powers of two below all rows.
static void draw_scale(tf_page *page, double y)
{
    for (int exponent = 0; exponent >= LOWEST; exponent -= 10) {
        tf_box box = bit_box(exponent, y);
        double x = box.x + box.width / 2;
        double tick[2][2] = {{x, y}, {x, y + 4}};
        tf_page_line(page, 2, (const double(*)[2])tick,
                     (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                                 .width = TF_WIDTH_THIN});
        char text[16];
        snprintf(text, sizeof text, "$2^{%d}$", exponent);
        tf_page_text(page, x, y + 16, TF_ALIGN_CENTER, text, TF_LETTERS_SMALL,
                     TF_ROLE_INK);
    }
}

/// Where the last place of `hi` ends.
static void draw_cut(tf_page *page, double hi, double above, double below)
{
    tf_box box = bit_box(ilogb(hi) - DOUBLE_BITS, above);
    double x = box.x - 0.3, line[2][2] = {{x, above}, {x, below}};
    tf_page_line(page, 2, (const double(*)[2])line,
                 (tf_stroke){.width = TF_WIDTH_THIN, .dash = 3});
}

static void draw(tf_page *page, FILE *numbers)
{
    tf_two sum = tf_two_sum(a, b);
    const double row[] = {8, 26, 56, 74};
    name_row(page, row[0], "$a$", TF_ROLE_EDGE);
    draw_bits(page, row[0], a, TF_ROLE_EDGE);
    name_row(page, row[1], "$b$", TF_ROLE_POINT);
    draw_bits(page, row[1], b, TF_ROLE_POINT);
    name_row(page, row[2], "hi", TF_ROLE_INK);
    draw_bits(page, row[2], sum.hi, TF_ROLE_INK);
    name_row(page, row[3], sum.lo < 0 ? "−lo" : "lo", TF_ROLE_CONTACT);
    draw_bits(page, row[3], sum.lo, TF_ROLE_CONTACT);
    draw_cut(page, sum.hi, row[0] - 4, row[3] + height + 4);
    draw_scale(page, row[3] + height + 6);
    tf_figure_number(numbers, "hi", sum.hi);
    tf_figure_number(numbers, "lo", sum.lo);
    tf_figure_number(numbers, "hi_last", ilogb(sum.hi) - DOUBLE_BITS + 1);
    tf_figure_number(numbers, "lo_first", ilogb(sum.lo));
}

const tf_figure tf_figure_two_sum = {
    .name = "two-sum",
    .title = "The sum of two doubles as two doubles, bit by bit",
    .width = TF_FIGURE_WIDTH,
    .height = 116,
    .draw = draw,
};
