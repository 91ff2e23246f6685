// A chain that falls into a box, answered by the response alone, and by a
// response that comes to terms with the springs.
#include "kit/cloth_run.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <stdio.h>

enum {
    STEPS = 200,
    RUNS = 2
};

static const fig_cloth_plan plans[RUNS] = {
    {.scene = "plane-chain",
     .size = 200,
     .steps = STEPS,
     .chosen = true,
     .friction = 0.3},
    {.scene = "plane-chain", .size = 200, .steps = STEPS},
};

static const struct {
    const char *name, *key;
    fig_role role;
} told[RUNS] = {{"alone", "the response alone", FIG_ROLE_CONTACT},
                {"coupled", "with a relaxation", FIG_ROLE_EDGE}};

/// The step after which an edge is longest.
static int worst_step(const fig_cloth_run *run)
{
    int worst = 0;
    for (int n = 0; n <= run->steps; n++)
        if (run->step[n].stretch > run->step[worst].stretch)
            worst = n;
    return worst;
}

static void draw_chain(fig_page *page, fig_box box, const fig_cloth_run *run,
                       int step)
{
    fig_cloth *cloth = fig_cloth_run_film(run, step - 1, 1); // it has fallen
    fig_cloth_draw(cloth, page, box, 1, &(fig_cloth_look){0});
    fig_cloth_free(cloth);
}

static void draw_stretch(fig_page *page, const fig_plot *plot,
                         const fig_cloth_run *run, fig_role role)
{
    fig_point at[STEPS + 1];
    for (int n = 0; n <= STEPS; n++)
        at[n] = (fig_point){n, run->step[n].stretch};
    fig_plot_curve(page, plot, STEPS + 1, at,
                   (fig_stroke){.paint.role = role, .width = 1.5});
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {262, 22, 110, 100},
                     .x = {0, STEPS},
                     .y = {1, 2.5},
                     .ticks_x = 2,
                     .ticks_y = 3,
                     .name_x = "step",
                     .name_y = "stretch"};
    int step = worst_step(fig_cloth_run_of(&plans[0]));
    fig_plot_frame(page, &plot);
    for (int i = 0; i < RUNS; i++) {
        const fig_cloth_run *run = fig_cloth_run_of(&plans[i]);
        double left = 4 + 112.0 * i;
        fig_page_text(page, left + 52, 14, FIG_ALIGN_CENTER, told[i].key,
                      FIG_LETTERS, told[i].role);
        draw_chain(page, (fig_box){left, 20, 104, 112}, run, step);
        draw_stretch(page, &plot, run, told[i].role);
        char key[32];
        snprintf(key, sizeof key, "stretch_%s", told[i].name);
        fig_number(numbers, key, run->step[worst_step(run)].stretch);
    }
    fig_number(numbers, "step", step);
}

const fig_figure fig_staggered_chain = {
    .name = "staggered-chain",
    .title = "A chain that the response alone stretches",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .draw = draw,
};
