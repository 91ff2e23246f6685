// What the parts of a step cost for each triangle.
#include "kit/figures.h"
#include "kit/measured.h"

#include "renderer/plot.h"

#include <stdio.h>

enum {
    STEPS = 300,
    PARTS = 3
};

static const int starts[] = {320, 1280, 5120}; ///< triangles

enum {
    STARTS = sizeof starts / sizeof *starts
};

static const struct {
    const char *name;
    fig_role role;
} parts[PARTS] = {{"improve", FIG_ROLE_EDGE},
                  {"reconnect", FIG_ROLE_OTHER_EDGE},
                  {"advance", FIG_ROLE_TRIANGLE}};

/// Seconds of the first parts in a step.
static double seconds_of(int start, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += fig_measured("flowing %d %s", start, parts[i].name);
    return sum / STEPS;
}

/// The bar of all parts is drawn first, and over it those of fewer.
static void draw_bars(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < STARTS; i++) {
        for (int count = PARTS; count > 0; count--)
            fig_plot_bar(page, plot, i + 0.2, i + 0.8,
                         1e6 * seconds_of(starts[i], count) / starts[i],
                         (fig_paint){.role = parts[count - 1].role});
        char name[FIG_GROUPED];
        fig_plot_grouped(starts[i], name);
        fig_plot_tick(page, fig_plot_place(plot, i + 0.5, 0), name);
    }
}

static void print_numbers(FILE *numbers, int start)
{
    double all = seconds_of(start, PARTS);
    fig_number(numbers, "triangles", start);
    fig_number(numbers, "step", 1000 * all);
    for (int i = 0; i < PARTS; i++)
        fig_number(numbers, parts[i].name,
                   100 * (seconds_of(start, i + 1) - seconds_of(start, i)) /
                       all);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {50, 12, 220, 120},
                     .x = {0, STARTS},
                     .y = {0, 50},
                     .ticks_x = -1,
                     .name_y = "µs per triangle"};
    fig_plot_frame(page, &plot);
    draw_bars(page, &plot);
    fig_page_text(page, plot.box.x + plot.box.width / 2, 163, FIG_ALIGN_CENTER,
                  "triangles at the start", FIG_LETTERS, FIG_ROLE_INK);
    for (int i = 0; i < PARTS; i++)
        fig_plot_key(page, 290, 100 - 18.0 * i, parts[i].name, parts[i].role);
    print_numbers(numbers, starts[STARTS - 1]);
}

const fig_figure fig_flow_step_costs = {
    .name = "flow-step-costs",
    .title = "What the parts of a step cost",
    .width = FIG_PAGE_WIDTH,
    .height = 178,
    .draw = draw,
};
