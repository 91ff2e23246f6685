// Beads on a wire: rounds and visits by the number of sweeps in a round.
#include "kit/figures.h"

#include "kit/wire.h"
#include "renderer/plot.h"

#include <stdio.h>

enum {
    BEADS = 12,
    FEW = 5,
    USUAL = 30, ///< the library's choice
    MANY = 500
};

static const double gap = 0x1p-10;

static const int sweeps[] = {1,  2,  3,  5,   7,   10,  15,  20,  30,
                             40, 60, 80, 100, 150, 200, 300, 500, 1000};

enum {
    COUNTS = sizeof sweeps / sizeof *sweeps
};

static void draw_curve(fig_page *page, const fig_plot *plot,
                       const fig_point at[COUNTS], fig_role role)
{
    fig_plot_frame(page, plot);
    fig_plot_curve(page, plot, COUNTS, at,
                   (fig_stroke){.paint = {.role = role}});
    for (int i = 0; i < COUNTS; i++)
        fig_plot_dot(page, plot, at[i].x, at[i].y, 4, role);
}

static void print_rounds(FILE *numbers, const char *name, int count)
{
    char key[32];
    fig_wire course = fig_wire_kept(BEADS, gap, count);
    fig_number(numbers, name, count);
    snprintf(key, sizeof key, "rounds_%s", name);
    fig_number(numbers, key, course.rounds);
    snprintf(key, sizeof key, "visits_%s", name);
    fig_number(numbers, key, (double)course.visits);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_point rounds[COUNTS], visits[COUNTS];
    for (int i = 0; i < COUNTS; i++) {
        fig_wire course = fig_wire_kept(BEADS, gap, sweeps[i]);
        rounds[i] = (fig_point){sweeps[i], course.rounds};
        visits[i] = (fig_point){sweeps[i], (double)course.visits / 1000};
    }
    fig_plot plot = {.box = {40, 22, 140, 130},
                     .x = {1, 1000},
                     .y = {0, 40},
                     .log_x = true,
                     .name_x = "sweeps in a round",
                     .name_y = "rounds"};
    draw_curve(page, &plot, rounds, FIG_ROLE_CONTACT);
    plot.box.x += 196;
    plot.y[1] = 25;
    plot.name_y = "visits, thousands";
    draw_curve(page, &plot, visits, FIG_ROLE_EDGE);
    print_rounds(numbers, "few", FEW);
    print_rounds(numbers, "usual", USUAL);
    print_rounds(numbers, "many", MANY);
    fig_number(numbers, "beads", BEADS);
}

const fig_figure fig_sweep_counts = {
    .name = "sweep-counts",
    .title = "Beads on a wire, by the number of sweeps in a round",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
