// A stack of sheets with and without a separation: the gaps of its contacts, and
// the rounds that it takes to resolve each step.
#include "kit/cloth_run.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>

enum {
    STEPS = 250,
    RUNS = 2,
    ZONE_ROUNDS = 20 ///< the library's choice: then the failsafe
};

static const struct {
    const char *name, *key;
    double separation;
    fig_role role;
} choice[RUNS] = {
    {"close", "no separation", -1, FIG_ROLE_CONTACT},
    {"apart", "a twentieth of an edge", 0, FIG_ROLE_EDGE},
};

static const fig_cloth_run *run_of(int i)
{
    return fig_cloth_run_of(
        &(fig_cloth_plan){.scene = "stack",
                          .size = 8,
                          .steps = STEPS,
                          .chosen = true,
                          .friction = 0.3,
                          .separation = choice[i].separation});
}

static int rounds_of(const fig_cloth_step *step)
{
    int rounds = 0;
    for (int level = 0; level < TF_LEVELS; level++)
        rounds += step->report.rounds[level];
    return rounds;
}

/// The smallest gap of each step that has a contact, in millimeters.
static void draw_gaps(fig_page *page, const fig_plot *plot, int i)
{
    const fig_cloth_run *run = run_of(i);
    for (int n = 1; n <= STEPS; n++) {
        const tf_response_report *report = &run->step[n].report;
        if (report->contacts > 0)
            fig_plot_dot(page, plot, n, 1000 * report->smallest_gap, 2,
                         choice[i].role);
    }
}

static void draw_rounds(fig_page *page, const fig_plot *plot, int i)
{
    const fig_cloth_run *run = run_of(i);
    for (int n = 1; n <= STEPS; n++)
        if (rounds_of(&run->step[n]) > 0)
            fig_plot_dot(page, plot, n, rounds_of(&run->step[n]), 2,
                         choice[i].role);
}

static void print_run(FILE *numbers, int i)
{
    const fig_cloth_run *run = run_of(i);
    double contacts = 0, rounds = 0;
    char key[32];
    for (int n = 1; n <= STEPS; n++) {
        contacts += (double)run->step[n].report.contacts;
        rounds += rounds_of(&run->step[n]);
    }
    snprintf(key, sizeof key, "contacts_%s", choice[i].name);
    fig_number(numbers, key, contacts);
    snprintf(key, sizeof key, "rounds_%s", choice[i].name);
    fig_number(numbers, key, rounds);
    snprintf(key, sizeof key, "failsafe_%s", choice[i].name);
    fig_number(numbers, key, fig_cloth_run_count(run, TF_FAILSAFE));
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot gaps = {.box = {46, 8, 140, 132},
                     .x = {0, STEPS},
                     .y = {1e-7, 10},
                     .log_y = true,
                     .ticks_x = 4,
                     .name_x = "step",
                     .name_y = "smallest gap, mm"};
    fig_plot rounds = {.box = {230, 8, 140, 132},
                       .x = {0, STEPS},
                       .y = {0, 40},
                       .ticks_x = 4,
                       .name_x = "step",
                       .name_y = "rounds"};
    fig_plot_frame(page, &gaps);
    fig_plot_frame(page, &rounds);
    fig_plot_level(page, &rounds, ZONE_ROUNDS);
    for (int i = 0; i < RUNS; i++) {
        draw_gaps(page, &gaps, i);
        draw_rounds(page, &rounds, i);
        fig_plot_key(page, 80 + 130.0 * i, 182, choice[i].key, choice[i].role);
        print_run(numbers, i);
    }
    fig_number(numbers, "steps", STEPS);
}

const fig_figure fig_room_to_move = {
    .name = "room-to-move",
    .title = "A stack of sheets with and without a separation",
    .width = FIG_PAGE_WIDTH,
    .height = 192,
    .draw = draw,
};
