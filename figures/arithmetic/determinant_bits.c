// How the bits of an integer are spent on a determinant.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/integer.h"

#include <math.h>

enum {
    ROWS = 4,
    BITS_MOST = 128
};

/// A word, and the determinant that it is to hold.
typedef struct budget {
    const tf_arithmetic *arithmetic;
    int word, axes;
    const char *key, *name;
} budget;

static const budget budgets[ROWS] = {
    {&tf_integer64, 64, 2, "plane_64", "plane, 64 bits"},
    {&tf_integer64, 64, 3, "space_64", "space, 64 bits"},
    {&tf_integer128, 128, 2, "plane_128", "plane, 128 bits"},
    {&tf_integer128, 128, 3, "space_128", "space, 128 bits"}};

static const double left = 14, first_top = 22, row_height = 42, bar_height = 16;

/// What a bit is spent on.
typedef enum purpose {
    SIGN,
    TERMS,
    ENTRY,
    FREE
} purpose;

static const fig_paint paint_of[] = {
    [SIGN] = {.role = FIG_ROLE_INK},
    [TERMS] = {.role = FIG_ROLE_NEUTRAL},
    [ENTRY] = {.role = FIG_ROLE_NEUTRAL, .opacity = 0.35},
    [FREE] = {.role = FIG_ROLE_NEUTRAL}}; // an outline

/// The bits of a sum of all terms, 2 or 6, beyond those of one.
static int term_bits(int axes)
{
    return axes == 2 ? 1 : 3;
}

/// All bits of the sign, the terms and the entries, each a difference.
static int spent_bits(const budget *b)
{
    return 1 + term_bits(b->axes) +
           b->axes * (b->arithmetic->bits[b->axes] + 1);
}

/// The bits of the largest determinant, its sign aside: its rows are
/// differences of opposite corners of the range.
static int largest_bits(const budget *b)
{
    static const double sign[4][3][3] = {
        [2] = {{1, 1}, {-1, 1}}, [3] = {{1, 1, -1}, {-1, 1, 1}, {1, -1, 1}}};
    double most = ldexp(1, b->arithmetic->bits[b->axes]) - 1;
    tf_event to[3] = {{.t = 0}}, from[3] = {{.t = 0}};
    tf_differences d = {.n = b->axes};
    for (int i = 0; i < b->axes; i++) {
        d.to[i] = &to[i];
        d.from[i] = &from[i];
        d.axis[i] = i;
        for (int j = 0; j < b->axes; j++) {
            to[i].x[j] = sign[b->axes][i][j] * most;
            from[i].x[j] = -to[i].x[j];
        }
    }
    return ilogb(b->arithmetic->value(&d).number) + 1;
}

static double bit_width(fig_page *page)
{
    return (fig_page_width(page) - 2 * left) / BITS_MOST;
}

/// A box of what bits are spent on; those left over are an empty outline.
static void draw_box(fig_page *page, fig_box box, purpose what)
{
    if (what != FREE) {
        fig_page_fill_box(page, box, paint_of[what]);
        return;
    }
    double x[2] = {box.x + 0.4, box.x + box.width - 0.4};
    double y[2] = {box.y + 0.4, box.y + box.height - 0.4};
    fig_page_line(
        page, 4,
        (fig_point[]){{x[0], y[0]}, {x[1], y[0]}, {x[1], y[1]}, {x[0], y[1]}},
        (fig_stroke){.paint = paint_of[FREE],
                     .width = FIG_WIDTH_THIN,
                     .closed = true,
                     .under_labels = true});
}

/// A run of bits with its number written in it; returns where it ends.
static double draw_run(fig_page *page, double x, double y, int count,
                       purpose what)
{
    if (count == 0)
        return x;
    double width = count * bit_width(page);
    draw_box(page, (fig_box){x, y, width - 0.8, bar_height}, what);
    char text[16];
    snprintf(text, sizeof text, "%d", count);
    if (width > 9)
        fig_page_text(page, x + width / 2, y + bar_height - 4.5,
                      FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    return x + width;
}

/// How far the largest determinant reaches from the right end of the bar.
static void draw_largest(fig_page *page, double end, double y, int count)
{
    double begin = end - count * bit_width(page), foot = y + bar_height + 3;
    fig_point at[2] = {{end - 0.8, foot}, {begin, foot}};
    fig_page_line(page, 2, at,
                  (fig_stroke){.width = FIG_WIDTH_LINE, .under_labels = true});
    for (int i = 0; i < 2; i++) {
        fig_point tick[2] = {{at[i].x, foot - 2}, {at[i].x, foot + 2}};
        fig_page_line(
            page, 2, tick,
            (fig_stroke){.width = FIG_WIDTH_LINE, .under_labels = true});
    }
    char text[16];
    snprintf(text, sizeof text, "%d", count);
    fig_page_text(page, (begin + end) / 2, foot + 10, FIG_ALIGN_CENTER, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_budget(fig_page *page, int row, FILE *numbers)
{
    const budget *b = &budgets[row];
    int spent = spent_bits(b), largest = largest_bits(b);
    double y = first_top + row * row_height, x = left;
    double end = left + b->word * bit_width(page);
    fig_page_text(page, left, y - 4, FIG_ALIGN_LEFT, b->name, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    x = draw_run(page, x, y, b->word - spent, FREE);
    x = draw_run(page, x, y, 1, SIGN);
    x = draw_run(page, x, y, term_bits(b->axes), TERMS);
    for (int i = 0; i < b->axes; i++)
        x = draw_run(page, x, y, b->arithmetic->bits[b->axes] + 1, ENTRY);
    draw_largest(page, end, y, largest);

    char key[32];
    snprintf(key, sizeof key, "spent_%s", b->key);
    fig_number(numbers, key, spent);
    snprintf(key, sizeof key, "largest_%s", b->key);
    fig_number(numbers, key, largest);
}

/// A colored square and what it stands for, one below the other at the right.
static void draw_key(fig_page *page, int line, purpose what, const char *text)
{
    double x = fig_page_width(page) / 2 + 40, y = first_top + 10 + 16 * line;
    draw_box(page, (fig_box){x, y - 8, 9, 9}, what);
    fig_page_text(page, x + 15, y, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int row = 0; row < ROWS; row++)
        draw_budget(page, row, numbers);
    draw_key(page, 0, SIGN, "the sign");
    draw_key(page, 1, TERMS, "for the sum of all terms");
    draw_key(page, 2, ENTRY, "for a factor, a difference");
    draw_key(page, 3, FREE, "left over");
}

const fig_figure fig_determinant_bits = {
    .name = "determinant-bits",
    .title = "How the bits of an integer are spent on a determinant",
    .width = FIG_PAGE_WIDTH,
    .height = 192,
    .draw = draw,
};
