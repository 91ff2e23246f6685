// What is refused when rolls of growing gaps are remeshed, by test.
#include "kit/figures.h"
#include "kit/remeshed.h"

#include "renderer/plot.h"

#include <stdio.h>

enum {
    GAPS = 6,
    TESTS = 2,
    ROUNDS = 3
};

static const double edge = 0.2, gaps[GAPS] = {0.01, 0.05, 0.1, 0.15, 0.2, 0.4};

/// Percent of the operations tried, that S refuses and that other tests do.
static void measure(double gap, double percent[TESTS])
{
    static fig_remeshing all;
    fig_some_mesh roll = fig_roll_of_sheet(0.3, gap * edge, 3, 0.07);
    fig_remesh(&roll, edge, ROUNDS, false, &all);
    const tf_remesh_report *report = &all.report[ROUNDS - 1];
    double all_tests = 0;
    for (int i = TF_IMPOSSIBLE; i < TF_OUTCOMES; i++)
        all_tests += fig_remesh_refused(report, (tf_outcome)i);
    double unit = 100 / fig_remesh_tried(report);
    percent[0] = unit * fig_remesh_refused(report, TF_OVERLAPPED);
    percent[1] = unit * all_tests - percent[0];
    fig_remeshing_free(&all);
    fig_some_mesh_free(&roll);
}

static void draw_bars(fig_page *page, const fig_plot *plot, int i,
                      const double percent[TESTS])
{
    // The higher bar comes first, and the other is drawn over it.
    fig_plot_bar(page, plot, i + 0.15, i + 0.85, percent[0] + percent[1],
                 (fig_paint){.role = FIG_ROLE_CONTACT});
    fig_plot_bar(page, plot, i + 0.15, i + 0.85, percent[0],
                 (fig_paint){.role = FIG_ROLE_EDGE});
    char text[16];
    snprintf(text, sizeof text, "%g", gaps[i]);
    fig_plot_tick(page, fig_plot_place(plot, i + 0.5, 0), text);
}

static void draw(fig_page *page, FILE *numbers)
{
    static double percent[GAPS][TESTS];
    if (percent[0][0] == 0)
        for (int i = 0; i < GAPS; i++)
            measure(gaps[i], percent[i]);
    fig_plot plot = {.box = {46, 12, 236, 112},
                     .x = {0, GAPS},
                     .y = {0, 70},
                     .ticks_x = -1,
                     .name_y = "refused, %"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < GAPS; i++)
        draw_bars(page, &plot, i, percent[i]);
    fig_page_text(page, 164, 154, FIG_ALIGN_CENTER,
                  "gap between the layers, in $L$", FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    fig_plot_key(page, 292, 24, "by S", FIG_ROLE_EDGE);
    fig_plot_key(page, 292, 40, "otherwise", FIG_ROLE_CONTACT);
    double others = 0;
    for (int i = 0; i < GAPS; i++)
        others += percent[i][1];
    fig_number(numbers, "narrow_gap", gaps[0]);
    fig_number(numbers, "wide_gap", gaps[GAPS - 1]);
    fig_number(numbers, "narrow", percent[0][0]);
    fig_number(numbers, "wide", percent[GAPS - 1][0]);
    fig_number(numbers, "others", others);
}

const fig_figure fig_refused_operations = {
    .name = "refused-operations",
    .title = "How many operations are refused, by the gap between layers",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .draw = draw,
};
