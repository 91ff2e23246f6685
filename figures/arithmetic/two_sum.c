// The sum of two doubles as two doubles, bit by bit.
#include "kit/figures.h"

#include "arithmetic/two_sum.h"
#include "kit/bit_rows.h"

#include <math.h>

static const fig_bit_rows rows = {
    .left = 52,
    .cell = 3.9,
    .height = 11,
    .highest = 3,
    .lowest = -75 // the last place of b
};

/// pi, and e / 2^24, as doubles.
static const double a = 0x1.921fb54442d18p+1, b = 0x1.5bf0a8b145769p-23;

static void draw_row(fig_page *page, double y, const char *name, double x,
                     fig_role role)
{
    fig_bits_name(page, &rows, y, name, role);
    fig_bits(page, &rows, y, x, role);
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_two sum = tf_two_sum(a, b);
    int last = ilogb(sum.hi) - 52;
    const double row[] = {8, 26, 56, 74};
    double end = row[3] + rows.height;
    draw_row(page, row[0], "$a$", a, FIG_ROLE_EDGE);
    draw_row(page, row[1], "$b$", b, FIG_ROLE_POINT);
    draw_row(page, row[2], "hi", sum.hi, FIG_ROLE_INK);
    draw_row(page, row[3], sum.lo < 0 ? "−lo" : "lo", sum.lo, FIG_ROLE_INK);
    fig_bits_cut(page, &rows, last, row[0] - 4, end + 4);
    fig_bits_scale(page, &rows, end + 6);
    fig_number(numbers, "hi", sum.hi);
    fig_number(numbers, "lo", sum.lo);
    fig_number(numbers, "hi_last", last);
    fig_number(numbers, "lo_first", ilogb(sum.lo));
}

const fig_figure fig_two_sum = {
    .name = "two-sum",
    .title = "The sum of two doubles as two doubles, bit by bit",
    .width = FIG_PAGE_WIDTH,
    .height = 116,
    .draw = draw,
};
