// What a determinant is made of: the terms of expansions, each from its lowest
// bit to its highest, on the way from a product to the whole.
#include "figures.h"

#include "arithmetic/clamped.h"
#include "bench/expansion.h"

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

static void draw_term(tf_page *page, double y, double term)
{
    double from = place(ilogb(term) + 1), to = place(lowest_bit(term));
    tf_role role = term > 0 ? TF_ROLE_POSITIVE : TF_ROLE_NEGATIVE;
    tf_page_fill_box(page, (tf_box){from, y, to - from - 0.4, bar},
                     (tf_paint){.role = role});
}

/// Every other term a little lower, so that neighbors are told apart.
static void draw_row(tf_page *page, int row, const char *name,
                     const expansion *e)
{
    double y = 8 + row * row_height;
    for (int i = 0; i < e->count; i++)
        draw_term(page, y + (i % 2 == e->count % 2 ? 5 : 0), e->term[i]);
    tf_page_text(page, left - 8, y + 11, TF_ALIGN_RIGHT, name, TF_LETTERS_SMALL,
                 TF_ROLE_INK);
    char count[16];
    snprintf(count, sizeof count, "%d terms", e->count);
    tf_page_text(page, right + 6, y + 11, TF_ALIGN_LEFT, count,
                 TF_LETTERS_SMALL, TF_ROLE_INK);
}

static void draw_scale(tf_page *page, double y)
{
    double line[2][2] = {{left, y}, {right, y}};
    tf_page_line(page, 2, (const double(*)[2])line,
                 (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                             .width = TF_WIDTH_THIN});
    for (int exponent = 0; exponent >= LOWEST; exponent -= 20) {
        char text[16];
        snprintf(text, sizeof text, "$2^{%d}$", exponent);
        tf_page_text(page, place(exponent), y + 14, TF_ALIGN_CENTER, text,
                     TF_LETTERS_SMALL, TF_ROLE_INK);
    }
}

/// The bound on the estimate's error, through all rows.
static void draw_bound(tf_page *page, double bound, double below)
{
    double x = place(log2(bound)), line[2][2] = {{x, 4}, {x, below}};
    tf_page_line(page, 2, (const double(*)[2])line,
                 (tf_stroke){.paint = {.role = TF_ROLE_UNCERTAIN},
                             .width = TF_WIDTH_LINE,
                             .dash = 3});
    tf_page_text(page, x - 4, below - 3, TF_ALIGN_RIGHT, "$B$",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
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

static void draw(tf_page *page, FILE *numbers)
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
    tf_figure_number(numbers, "minor_terms", minor.count);
    tf_figure_number(numbers, "part_terms", part.count);
    tf_figure_number(numbers, "terms", whole.count);
    tf_figure_number(numbers, "estimate", estimate.number);
    tf_figure_number(numbers, "bound", estimate.bound);
    tf_figure_number(numbers, "last", whole.term[whole.count - 1]);
    tf_figure_number(numbers, "first_bit", ilogb(whole.term[whole.count - 1]));
    tf_figure_number(numbers, "last_bit", lowest_bit(whole.term[0]));
}

const tf_figure tf_figure_expansion_terms = {
    .name = "expansion-terms",
    .title = "The terms of a determinant's expansion on the exponent axis",
    .width = TF_FIGURE_WIDTH,
    .height = 136,
    .draw = draw,
};
