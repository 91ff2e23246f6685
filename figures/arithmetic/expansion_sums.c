// Two sums of expansions, term by term, in numbers of four bits.
#include "kit/figures.h"

#include "arithmetic/two_sum.h"
#include "base/require.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    BITS = 4,
    HIGHEST = 15, ///< the exponent of the leftmost column
    TERMS = 4,
    SUMS = 2
};

/// Two products as heads and tails, merged: the smallest term first, and in a
/// tie that of the second product, as in expansion_add.
static const struct sum {
    const char *key, *name;
    double term[TERMS];
} sums[SUMS] = {
    {"cancelling", "$13·11 - 10·14$", {-1, 4, -144, 144}},
    {"growing", "$208·176 + 13·13$", {-7, 176, -256, 36864}},
};

static const double left = 62, cell = 12.4, height = 10, row_height = 16;

// Numbers of four bits ---------------------------------------------------

static double toy_round(double x)
{
    int exponent;
    double fraction = frexp(x, &exponent);
    return ldexp(rint(ldexp(fraction, BITS)), exponent - BITS);
}

/// a + b, which is no toy number, in two that are.
static tf_two toy_two_sum(double a, double b)
{
    double hi = toy_round(a + b), lo = a + b - hi;
    TF_REQUIRE(toy_round(lo) == lo);
    return (tf_two){.hi = hi, .lo = lo};
}

// Running sums -----------------------------------------------------------

/// The sum of what has been added: terms that are final, smallest first, then
/// the carry.
typedef struct running {
    int count;
    double term[TERMS];
    tf_two carry;
} running;

static void append(running *sum, double term)
{
    if (term != 0)
        sum->term[sum->count++] = term;
}

static void add(running *sum, double term)
{
    tf_two low = toy_two_sum(term, sum->carry.lo);
    append(sum, low.lo);
    sum->carry = toy_two_sum(sum->carry.hi, low.hi);
}

static void finish(running *sum)
{
    append(sum, sum->carry.lo);
    append(sum, sum->carry.hi);
    sum->carry = (tf_two){0, 0};
}

// The picture ------------------------------------------------------------

static fig_box bit_box(int exponent, double y)
{
    return (fig_box){left + (HIGHEST - exponent) * cell, y, cell - 1.2, height};
}

/// From the highest bit of a term to its lowest: ones full, zeros pale.  A
/// frame is around a term that is final.
static void draw_term(fig_page *page, double y, double term, bool final)
{
    if (term == 0)
        return;
    fig_role role = term > 0 ? FIG_ROLE_POSITIVE : FIG_ROLE_NEGATIVE;
    int highest = ilogb(term), lowest = highest;
    for (int i = highest; fmod(term, ldexp(1, i + 1)) != 0 && i >= 0; i--) {
        bool one = fmod(floor(ldexp(fabs(term), -i)), 2) == 1;
        fig_page_fill_box(page, bit_box(i, y),
                          (fig_paint){.role = role, .opacity = one ? 1 : 0.25});
        lowest = i;
    }
    if (!final)
        return;
    fig_box from = bit_box(highest, y), to = bit_box(lowest, y);
    double x[2] = {from.x - 1.6, to.x + to.width + 1.6};
    fig_point corner[4] = {{x[0], y - 1.6},
                           {x[1], y - 1.6},
                           {x[1], y + height + 1.6},
                           {x[0], y + height + 1.6}};
    fig_page_line(page, 4, corner,
                  (fig_stroke){.width = FIG_WIDTH_LINE, .closed = true});
}

/// The terms as numbers, the largest first: "144 + 3".
static void write_terms(const running *sum, char *text, size_t size)
{
    double all[TERMS + 2] = {sum->carry.hi, sum->carry.lo};
    int count = 2;
    for (int i = sum->count - 1; i >= 0; i--)
        all[count++] = sum->term[i];
    size_t length = 0;
    for (int i = 0; i < count; i++) {
        if (all[i] == 0)
            continue;
        char number[FIG_GROUPED];
        fig_plot_grouped((long)fabs(all[i]), number);
        const char *sign = all[i] < 0 ? "-" : length > 0 ? "+" : "";
        length += (size_t)snprintf(text + length, size - length, "%s%s%s%s",
                                   length > 0 ? " " : "$", sign,
                                   length > 0 ? " " : "", number);
    }
    snprintf(text + length, size - length, "$");
}

static void draw_row(fig_page *page, double y, const running *sum, double added)
{
    char number[FIG_GROUPED], text[128];
    fig_plot_grouped((long)fabs(added), number);
    snprintf(text, sizeof text, "$%s %s$", added < 0 ? "-" : "+", number);
    fig_page_text(page, left - 12, y + height - 1.5, FIG_ALIGN_RIGHT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int i = 0; i < sum->count; i++)
        draw_term(page, y, sum->term[i], true);
    draw_term(page, y, sum->carry.lo, false);
    draw_term(page, y, sum->carry.hi, false);
    write_terms(sum, text, sizeof text);
    fig_page_text(page, left + (HIGHEST + 1) * cell + 10, y + height - 1.5,
                  FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static double draw_sum(fig_page *page, double y, const struct sum *s,
                       FILE *numbers)
{
    running sum = {.count = 0};
    fig_page_text(page, left, y + 8, FIG_ALIGN_LEFT, s->name, FIG_LETTERS,
                  FIG_ROLE_INK);
    y += 16;
    for (int i = 0; i < TERMS; i++, y += row_height) {
        add(&sum, s->term[i]);
        if (i == TERMS - 1)
            finish(&sum);
        draw_row(page, y, &sum, s->term[i]);
    }
    double value = 0;
    for (int i = 0; i < sum.count; i++)
        value += sum.term[i];
    fig_number(numbers, s->key, value);
    char key[32];
    snprintf(key, sizeof key, "%s_terms", s->key);
    fig_number(numbers, key, sum.count);
    return y;
}

/// Powers of two below all rows.
static void draw_scale(fig_page *page, double y)
{
    for (int exponent = 0; exponent <= HIGHEST; exponent += 3) {
        char text[16];
        snprintf(text, sizeof text, "$2^{%d}$", exponent);
        fig_box box = bit_box(exponent, y);
        fig_page_text(page, box.x + box.width / 2, y + 10, FIG_ALIGN_CENTER,
                      text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double y = 6;
    for (int i = 0; i < SUMS; i++)
        y = draw_sum(page, y, &sums[i], numbers) + 8;
    draw_scale(page, y - 4);
}

const fig_figure fig_expansion_sums = {
    .name = "expansion-sums",
    .title = "Two sums of expansions, term by term, in four bits",
    .width = FIG_PAGE_WIDTH,
    .height = 192,
    .draw = draw,
};
