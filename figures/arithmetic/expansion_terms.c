// What a determinant is made of: the terms of expansions, each from its lowest
// bit to its highest, on the way from a product to the whole.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/filter.h"
#include "kit/expansion.h"

#include <math.h>

enum {
    HIGHEST = 2,
    LOWEST = -168,
    ROWS = 4
};

static const double left = 62, right = 336, row_height = 26, bar = 10;

/// Three corners of a flat tetrahedron, whose fourth is the origin.
static double entry[TF_AXES][TF_AXES] = {
    {0x1.39adc5cd900e1p-2, -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2},
    {-0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2},
    {-0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4, 0x1.725a4884d51d7p-2}};

static double place(double exponent)
{
    return left + (HIGHEST - exponent) / (HIGHEST - LOWEST) * (right - left);
}

/// The exponent of the lowest bit that is set.
static int lowest_bit(double x)
{
    int exponent = ilogb(x);
    while (fmod(x, ldexp(1, exponent)) != 0)
        exponent--;
    return exponent;
}

static void draw_term(fig_page *page, double y, double term)
{
    double from = place(ilogb(term) + 1), to = place(lowest_bit(term));
    fig_role role = term > 0 ? FIG_ROLE_POSITIVE : FIG_ROLE_NEGATIVE;
    fig_page_fill_box(page, (fig_box){from, y, to - from - 0.4, bar},
                      (fig_paint){.role = role});
}

/// Every other term a little lower, so that neighbors can be distinguished.
static void draw_row(fig_page *page, int row, const char *name,
                     const expansion *e)
{
    double y = 8 + row * row_height;
    for (int i = 0; i < e->count; i++)
        draw_term(page, y + (i % 2 == e->count % 2 ? 5 : 0), e->term[i]);
    fig_page_text(page, left - 8, y + 11, FIG_ALIGN_RIGHT, name,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    char count[16];
    snprintf(count, sizeof count, "%d terms", e->count);
    fig_page_text(page, right + 6, y + 11, FIG_ALIGN_LEFT, count,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_scale(fig_page *page, double y)
{
    fig_point line[2] = {{left, y}, {right, y}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_THIN});
    for (int exponent = 0; exponent >= LOWEST; exponent -= 20) {
        char text[16];
        snprintf(text, sizeof text, "$2^{%d}$", exponent);
        fig_page_text(page, place(exponent), y + 14, FIG_ALIGN_CENTER, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
}

/// The bound on the estimate's error, through all rows.
static void draw_bound(fig_page *page, double bound, double below)
{
    double x = place(log2(bound));
    fig_point line[2] = {{x, 4}, {x, below}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.paint = {.role = FIG_ROLE_UNCERTAIN},
                               .width = FIG_WIDTH_LINE,
                               .dash = 3});
    fig_page_text(page, x - 4, below - 3, FIG_ALIGN_RIGHT, "$B$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static tf_estimate estimate_of_entries(void)
{
    tf_event row[TF_AXES], zero = {.x = {0}};
    tf_differences d = {.n = TF_AXES, .axis = {0, 1, 2}};
    for (int i = 0; i < TF_AXES; i++) {
        row[i] = (tf_event){.x = {entry[i][0], entry[i][1], entry[i][2]}};
        d.to[i] = &row[i];
        d.from[i] = &zero;
    }
    return tf_differences_estimate(&d);
}

/// The sum of the terms, rounded.
static double value_of(const expansion *e)
{
    double value = 0;
    for (int i = 0; i < e->count; i++)
        value += e->term[i];
    return value;
}

static void draw(fig_page *page, FILE *numbers)
{
    double lower[TF_AXES][TF_AXES] = {{entry[1][1], entry[1][2]},
                                      {entry[2][1], entry[2][2]}};
    expansion factor = {.count = 1, .term = {entry[1][1]}};
    expansion product, minor, part, whole;
    expansion_scale(&factor, entry[2][2], &product);
    expansion_determinant(2, lower, &minor);
    expansion_scale(&minor, entry[0][0], &part);
    expansion_determinant(3, entry, &whole);
    tf_estimate estimate = estimate_of_entries();

    double below = 8 + ROWS * row_height;
    draw_bound(page, estimate.bound, below);
    draw_row(page, 0, "product", &product);
    draw_row(page, 1, "minor", &minor);
    draw_row(page, 2, "part", &part);
    draw_row(page, 3, "whole", &whole);
    draw_scale(page, below);
    fig_number(numbers, "minor_terms", minor.count);
    fig_number(numbers, "part_terms", part.count);
    fig_number(numbers, "terms", whole.count);
    fig_number(numbers, "estimate", estimate.number);
    fig_number(numbers, "bound", estimate.bound);
    fig_number(numbers, "value", value_of(&whole));
    fig_number(numbers, "last", whole.term[whole.count - 1]);
    fig_number(numbers, "first_bit", ilogb(whole.term[whole.count - 1]));
    fig_number(numbers, "last_bit", lowest_bit(whole.term[0]));
}

const fig_figure fig_expansion_terms = {
    .name = "expansion-terms",
    .title = "The terms of a determinant's expansion, by exponent",
    .width = FIG_PAGE_WIDTH,
    .height = 136,
    .draw = draw,
};
