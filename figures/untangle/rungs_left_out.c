// How many edges the tangles that are measured have stretched in the end, and how
// far they are from home, with all rungs and without each of them.
#include "kit/figures.h"
#include "kit/measured.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    WAYS = 7,
    PANELS = 2
};

static const char *const ways[WAYS] = {"all",   "push",  "smooth", "again",
                                       "apart", "relax", "return"};

static const struct {
    const char *key, *title, *format;
} panels[PANELS] = {{"stretched", "edges stretched, percent", "%.1f"},
                    {"deviation", "rms distance from home, edges", "%.2f"}};

static double measured(int panel, int way)
{
    return fig_measured("untangling %s %s", panels[panel].key, ways[way]);
}

static double greatest(int panel)
{
    double most = 0;
    for (int i = 0; i < WAYS; i++)
        most = fmax(most, measured(panel, i));
    return most;
}

static void draw_bar(fig_page *page, const fig_plot *plot, int panel, int way)
{
    char text[32];
    double y = WAYS - way - 0.5, value = measured(panel, way);
    fig_point left = fig_plot_place(plot, 0, y + 0.32),
              right = fig_plot_place(plot, value, y - 0.32);
    fig_page_fill_box(
        page, (fig_box){left.x, left.y, right.x - left.x, right.y - left.y},
        (fig_paint){.role = way == 0 ? FIG_ROLE_TRIANGLE : FIG_ROLE_EDGE});
    double middle = (left.y + right.y) / 2 + 3;
    snprintf(text, sizeof text, panels[panel].format, value);
    fig_page_text(page, right.x + 4, middle, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    if (panel > 0)
        return;
    snprintf(text, sizeof text, way == 0 ? "all rungs" : "without *%s*",
             ways[way]);
    fig_page_text(page, plot->box.x - 6, middle, FIG_ALIGN_RIGHT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_panel(fig_page *page, int panel, FILE *numbers)
{
    fig_plot plot = {.box = {panel == 0 ? 78 : 232, 6, 118, 112},
                     .x = {0, greatest(panel)},
                     .y = {0, WAYS},
                     .name_x = panels[panel].title,
                     .ticks_y = -1};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < WAYS; i++) {
        char key[32];
        draw_bar(page, &plot, panel, i);
        snprintf(key, sizeof key, "%s_%s", panels[panel].key, ways[i]);
        fig_number(numbers, key, measured(panel, i));
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < PANELS; i++)
        draw_panel(page, i, numbers);
    fig_number(numbers, "tangles", fig_measured("untangling tangles"));
    fig_number(numbers, "always", fig_measured("untangling always clear"));
}

const fig_figure fig_rungs_left_out = {
    .name = "rungs-left-out",
    .title = "What each rung of an untangling is good for",
    .width = FIG_PAGE_WIDTH,
    .height = 154,
    .draw = draw,
};
