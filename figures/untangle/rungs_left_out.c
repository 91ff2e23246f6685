// How many of the tangles that are measured end clear, with all rungs and without
// each of them.
#include "kit/figures.h"
#include "kit/measured.h"
#include "renderer/plot.h"

enum {
    WAYS = 7
};

static const char *const ways[WAYS] = {"all",   "push",  "smooth", "again",
                                       "apart", "relax", "return"};

static double clear(int way)
{
    return fig_measured("untangling clear %s", ways[way]);
}

static void draw(fig_page *page, FILE *numbers)
{
    double tangles = fig_measured("untangling tangles");
    fig_plot plot = {.box = {96, 6, 250, 112},
                     .x = {0, tangles},
                     .y = {0, WAYS},
                     .name_x = "clear",
                     .ticks_y = -1};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < WAYS; i++) {
        char text[32];
        double y = WAYS - i - 0.5;
        fig_point left = fig_plot_place(&plot, 0, y + 0.32),
                  right = fig_plot_place(&plot, clear(i), y - 0.32);
        fig_page_fill_box(
            page, (fig_box){left.x, left.y, right.x - left.x, right.y - left.y},
            (fig_paint){.role = i == 0 ? FIG_ROLE_TRIANGLE : FIG_ROLE_EDGE});
        snprintf(text, sizeof text, i == 0 ? "all rungs" : "without *%s*",
                 ways[i]);
        double middle = (left.y + right.y) / 2 + 3;
        fig_page_text(page, plot.box.x - 6, middle, FIG_ALIGN_RIGHT, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        snprintf(text, sizeof text, "%g", clear(i));
        fig_page_text(page, right.x + 4, middle, FIG_ALIGN_LEFT, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        snprintf(text, sizeof text, "clear_%s", ways[i]);
        fig_number(numbers, text, clear(i));
    }
    fig_number(numbers, "tangles", tangles);
}

const fig_figure fig_rungs_left_out = {
    .name = "rungs-left-out",
    .title = "What each rung of an untangling is good for",
    .width = FIG_PAGE_WIDTH,
    .height = 154,
    .draw = draw,
};
