// Where the estimate leaves a sign open, a pixel a double, and whether some
// difference is rounded there.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/clamped.h"
#include "arithmetic/two_sum.h"
#include "renderer/plot.h"

enum {
    CELLS = 96 // doubles along each side of the map
};

typedef enum decision {
    BY_ESTIMATE,
    OF_WHOLES,
    OF_TAILS,
    DECISIONS
} decision;

/// The line goes through these two points of the diagonal.
static const double near_end = 1.125, far_end = 1.375;

static const double side = 228, map_left = 24, map_top = 10;

/// The i-th double from 1/2 on, upwards or downwards.
static double step_from_half(int i)
{
    return 0.5 + i * (i < 0 ? 0x1p-54 : 0x1p-53);
}

static fig_paint decision_paint(decision d)
{
    static const fig_paint paint[DECISIONS] = {
        {.role = FIG_ROLE_NEUTRAL, .shade = -0.75},
        {.role = FIG_ROLE_START},
        {.role = FIG_ROLE_END}};
    return paint[d];
}

/// What decides on which side of the line the point (x, y) lies.
static decision decide(double x, double y)
{
    tf_event p = {.x = {x, y}};
    tf_event q = {.x = {near_end, near_end}}, r = {.x = {far_end, far_end}};
    tf_differences d = {
        .n = 2, .to = {&q, &r}, .from = {&p, &p}, .axis = {0, 1}};
    if (tf_clamped.sign(&d) != TF_UNKNOWN)
        return BY_ESTIMATE;
    for (int k = 0; k < 2; k++)
        if (tf_two_difference(q.x[k], p.x[k]).lo != 0 ||
            tf_two_difference(r.x[k], p.x[k]).lo != 0)
            return OF_TAILS;
    return OF_WHOLES;
}

/// Find all decisions and count them, with the highest row of cells first.
static void fill_map(const fig_theme *theme, fig_rgb cell[],
                     int count[DECISIONS])
{
    for (int j = CELLS / 2 - 1; j >= -CELLS / 2; j--)
        for (int i = -CELLS / 2; i < CELLS / 2; i++) {
            decision by = decide(step_from_half(i), step_from_half(j));
            count[by]++;
            *cell++ = fig_paint_color(theme, decision_paint(by));
        }
}

static void draw_diagonal(fig_page *page)
{
    fig_point line[2] = {{map_left, map_top + side},
                         {map_left + side, map_top}};
    fig_page_line(page, 2, line,
                  (fig_stroke){.width = FIG_WIDTH_LINE, .under_labels = true});
}

/// The axes through (1/2, 1/2), where the distance of doubles changes.
static void draw_halves(fig_page *page)
{
    double x = map_left + side / 2, y = map_top + side / 2;
    fig_point down[2] = {{x, map_top}, {x, map_top + side + 4}};
    fig_point across[2] = {{map_left - 4, y}, {map_left + side, y}};
    fig_stroke thin = {.width = FIG_WIDTH_HAIR, .under_labels = true};
    fig_page_line(page, 2, down, thin);
    fig_page_line(page, 2, across, thin);
    fig_page_text(page, x, map_top + side + 14, FIG_ALIGN_CENTER, "$1/2$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, map_left - 7, y + 3, FIG_ALIGN_RIGHT, "$1/2$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, map_left + side, map_top + side + 14, FIG_ALIGN_RIGHT,
                  "$p_x$", FIG_LETTERS, FIG_ROLE_INK);
    fig_page_text(page, map_left - 7, map_top + 9, FIG_ALIGN_RIGHT, "$p_y$",
                  FIG_LETTERS, FIG_ROLE_INK);
}

static void draw_key(fig_page *page, decision by, int count)
{
    static const char *const name[DECISIONS][2] = {
        {"estimate", ""},
        {"left open,", "whole differences"},
        {"left open,", "heads and tails"}};
    double x = map_left + side + 14, y = map_top + 24 + 50 * (double)by;
    fig_page_fill_box(page, (fig_box){x, y - 8, 9, 9}, decision_paint(by));
    for (int line = 0; line < 2; line++)
        fig_page_text(page, x + 14, y + 13 * line, FIG_ALIGN_LEFT,
                      name[by][line], FIG_LETTERS, FIG_ROLE_INK);
    char text[FIG_GROUPED];
    fig_plot_grouped(count, text);
    fig_page_text(page, x + 14, y + (by == BY_ESTIMATE ? 14 : 27),
                  FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const key[DECISIONS] = {"estimate", "wholes", "tails"};
    static fig_rgb cell[CELLS * CELLS];
    int count[DECISIONS] = {0};
    fill_map(fig_page_theme(page), cell, count);
    fig_page_map(page, (fig_box){map_left, map_top, side, side}, CELLS, CELLS,
                 cell);
    draw_diagonal(page);
    draw_halves(page);
    for (int i = 0; i < DECISIONS; i++) {
        draw_key(page, (decision)i, count[i]);
        fig_number(numbers, key[i], count[i]);
    }
    fig_number(numbers, "open", count[OF_WHOLES] + count[OF_TAILS]);
}

const fig_figure fig_exact_stages = {
    .name = "exact-stages",
    .title = "Where the estimate leaves a sign open",
    .width = FIG_PAGE_WIDTH,
    .height = 262,
    .draw = draw,
};
