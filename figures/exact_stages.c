// Which stage of the exact arithmetic finds a sign, a pixel a double.
#include "figures.h"

#include "arithmetic/exact.h"

enum {
    CELLS = 96, // doubles along each side of the map
    STAGES = TF_BY_ACCUMULATOR + 1
};

/// The line goes through these two points of the diagonal.
static const double near_end = 1.125, far_end = 1.375;

static const double side = 228, map_left = 24, map_top = 10;

/// The i-th double from 1/2 on, upwards or downwards.
static double step_from_half(int i)
{
    return 0.5 + i * (i < 0 ? 0x1p-54 : 0x1p-53);
}

static tf_paint stage_paint(tf_stage by)
{
    static const tf_paint paint[STAGES] = {
        {.role = TF_ROLE_NEUTRAL, .shade = -0.75},
        {.role = TF_ROLE_START},
        {.role = TF_ROLE_END}};
    return paint[by];
}

/// Find all stages and count them, with the highest row of cells first.
static void fill_map(const tf_theme *theme, tf_rgb cell[], int count[STAGES])
{
    for (int j = CELLS / 2 - 1; j >= -CELLS / 2; j--)
        for (int i = -CELLS / 2; i < CELLS / 2; i++) {
            tf_event p = {.x = {step_from_half(i), step_from_half(j)}};
            tf_event q = {.x = {near_end, near_end}};
            tf_event r = {.x = {far_end, far_end}};
            tf_differences d = {
                .n = 2, .to = {&q, &r}, .from = {&p, &p}, .axis = {0, 1}};
            tf_stage by;
            tf_exact_sign(&d, &by);
            count[by]++;
            *cell++ = tf_paint_color(theme, stage_paint(by));
        }
}

static void draw_diagonal(tf_page *page)
{
    double line[2][2] = {{map_left, map_top + side},
                         {map_left + side, map_top}};
    tf_page_line(page, 2, (const double(*)[2])line,
                 (tf_stroke){.width = TF_WIDTH_LINE, .under_labels = true});
}

/// The axes through (1/2, 1/2), where the distance of doubles changes.
static void draw_halves(tf_page *page)
{
    double x = map_left + side / 2, y = map_top + side / 2;
    double down[2][2] = {{x, map_top}, {x, map_top + side + 4}};
    double across[2][2] = {{map_left - 4, y}, {map_left + side, y}};
    tf_stroke thin = {.width = TF_WIDTH_HAIR, .under_labels = true};
    tf_page_line(page, 2, (const double(*)[2])down, thin);
    tf_page_line(page, 2, (const double(*)[2])across, thin);
    tf_page_text(page, x, map_top + side + 14, TF_ALIGN_CENTER, "$1/2$",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    tf_page_text(page, map_left - 7, y + 3, TF_ALIGN_RIGHT, "$1/2$",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    tf_page_text(page, map_left + side, map_top + side + 14, TF_ALIGN_RIGHT,
                 "$p_x$", TF_LETTERS, TF_ROLE_INK);
    tf_page_text(page, map_left - 7, map_top + 9, TF_ALIGN_RIGHT, "$p_y$",
                 TF_LETTERS, TF_ROLE_INK);
}

static void draw_key(tf_page *page, tf_stage by, const char *name, int count)
{
    double x = map_left + side + 14, y = map_top + 24 + 44 * (double)by;
    tf_page_fill_box(page, (tf_box){x, y - 8, 9, 9}, stage_paint(by));
    tf_page_text(page, x + 14, y, TF_ALIGN_LEFT, name, TF_LETTERS, TF_ROLE_INK);
    char text[32];
    snprintf(text, sizeof text, "%d", count);
    tf_page_text(page, x + 14, y + 14, TF_ALIGN_LEFT, text, TF_LETTERS_SMALL,
                 TF_ROLE_INK);
}

static void draw(tf_page *page, FILE *numbers)
{
    static const char *const name[STAGES] = {"estimate", "expansion",
                                             "accumulator"};
    static tf_rgb cell[CELLS * CELLS];
    int count[STAGES] = {0};
    fill_map(tf_page_theme(page), cell, count);
    tf_page_map(page, (tf_box){map_left, map_top, side, side}, CELLS, CELLS,
                cell);
    draw_diagonal(page);
    draw_halves(page);
    for (int i = 0; i < STAGES; i++) {
        draw_key(page, (tf_stage)i, name[i], count[i]);
        tf_figure_number(numbers, name[i], count[i]);
    }
}

const tf_figure tf_figure_exact_stages = {
    .name = "exact-stages",
    .title = "Which stage of the exact arithmetic finds a sign",
    .width = TF_FIGURE_WIDTH,
    .height = 262,
    .draw = draw,
};
