// Two scenes in the course of time: rounds, stretch and energies of each step.
#include "kit/cloth_run.h"
#include "kit/figures.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    SCENES = 2
};

static const fig_cloth_plan plans[SCENES] = {
    {.scene = "sphere", .size = 10, .steps = 240},
    {.scene = "twist", .size = 6, .steps = 500},
};

static const double left = 38, width = 138, apart = 194;

/// The top and the height of the three plots.
static const double tops[] = {20, 108, 196}, height = 62;

static fig_plot plot_of(int scene, int row, double low, double high)
{
    static const char *const name[] = {"rounds", "stretch", "energy, J"};
    return (fig_plot){.box = {left + apart * scene, tops[row], width, height},
                      .x = {0, plans[scene].steps},
                      .y = {low, high},
                      .ticks_x = 4,
                      .ticks_y = 3,
                      .name_x = row == 2 ? "step" : NULL,
                      .name_y = scene == 0 ? name[row] : NULL};
}

static int rounds_of(const fig_cloth_step *step)
{
    return step->report.rounds[TF_ZONES] + step->report.rounds[TF_FAILSAFE];
}

static void draw_rounds(fig_page *page, int scene, const fig_cloth_run *run)
{
    int most = 1;
    for (int i = 1; i <= run->steps; i++)
        most =
            rounds_of(&run->step[i]) > most ? rounds_of(&run->step[i]) : most;
    fig_plot plot = plot_of(scene, 0, 0, 1.4 * most);
    fig_plot_frame(page, &plot);
    for (int i = 1; i <= run->steps; i++) {
        const fig_cloth_step *step = &run->step[i];
        // The zones' bar is drawn over that of both.
        if (step->report.rounds[TF_FAILSAFE] > 0)
            fig_plot_bar(page, &plot, i - 1, i, rounds_of(step),
                         (fig_paint){.role = FIG_ROLE_CONTACT});
        fig_plot_bar(page, &plot, i - 1, i, step->report.rounds[TF_ZONES],
                     (fig_paint){.role = FIG_ROLE_EDGE});
    }
}

/// A curve of numbers that each step has.
static void draw_curve(fig_page *page, const fig_plot *plot,
                       const fig_cloth_run *run,
                       double (*value)(const fig_cloth_step *step),
                       fig_stroke stroke)
{
    fig_point *at = malloc(sizeof *at * ((size_t)run->steps + 1));
    if (!at)
        return;
    for (int i = 0; i <= run->steps; i++)
        at[i] = (fig_point){i, value(&run->step[i])};
    fig_plot_curve(page, plot, run->steps, at + 1, stroke);
    free(at);
}

static double stretch_of(const fig_cloth_step *step)
{
    return step->stretch;
}

static double kinetic_of(const fig_cloth_step *step)
{
    return fmax(step->kinetic, 1e-12);
}

static double elastic_of(const fig_cloth_step *step)
{
    return fmax(step->elastic, 1e-12);
}

static double most_stretch(const fig_cloth_run *run)
{
    double most = 1;
    for (int i = 1; i <= run->steps; i++)
        most = fmax(most, run->step[i].stretch);
    return most;
}

static double contacts_of(const fig_cloth_run *run)
{
    double sum = 0;
    for (int i = 1; i <= run->steps; i++)
        sum += (double)run->step[i].report.contacts;
    return sum;
}

static void draw_stretch(fig_page *page, int scene, const fig_cloth_run *run)
{
    fig_plot plot = plot_of(scene, 1, 1, 1 + 1.2 * (most_stretch(run) - 1));
    fig_plot_frame(page, &plot);
    draw_curve(page, &plot, run, stretch_of,
               (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .width = 1.6});
}

static void draw_energies(fig_page *page, int scene, const fig_cloth_run *run)
{
    fig_plot plot = plot_of(scene, 2, 1e-6, 10);
    plot.log_y = true;
    fig_plot_frame(page, &plot);
    draw_curve(page, &plot, run, kinetic_of,
               (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    draw_curve(page, &plot, run, elastic_of,
               (fig_stroke){.paint = {.role = FIG_ROLE_OTHER_EDGE}});
}

static void write_keys(fig_page *page)
{
    double x = left + 4;
    fig_plot_key(page, x, tops[0] + 6, "zones", FIG_ROLE_EDGE);
    fig_plot_key(page, x + 46, tops[0] + 6, "failsafe", FIG_ROLE_CONTACT);
    double low = tops[2] + height - 10;
    fig_plot_key(page, x + 16, low, "kinetic", FIG_ROLE_EDGE);
    fig_plot_key(page, x + 70, low, "elastic", FIG_ROLE_OTHER_EDGE);
}

static void print_number(FILE *numbers, const char *what, int scene,
                         double value)
{
    char key[64];
    snprintf(key, sizeof key, "%s_%s", what, plans[scene].scene);
    fig_number(numbers, key, value);
}

static void draw_scene(fig_page *page, FILE *numbers, int scene)
{
    const fig_cloth_run *run = fig_cloth_run_of(&plans[scene]);
    draw_rounds(page, scene, run);
    draw_stretch(page, scene, run);
    draw_energies(page, scene, run);
    fig_page_title(page, plot_of(scene, 0, 0, 1).box, plans[scene].scene);
    print_number(numbers, "steps", scene, plans[scene].steps);
    print_number(numbers, "zones", scene, fig_cloth_run_count(run, TF_ZONES));
    print_number(numbers, "failsafe", scene,
                 fig_cloth_run_count(run, TF_FAILSAFE));
    print_number(numbers, "stretch", scene, most_stretch(run));
    print_number(numbers, "contacts", scene, contacts_of(run));
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int scene = 0; scene < SCENES; scene++)
        draw_scene(page, numbers, scene);
    write_keys(page);
}

const fig_figure fig_scenes_over_time = {
    .name = "scenes-over-time",
    .title = "Rounds, stretch and energy of two scenes over time",
    .width = FIG_PAGE_WIDTH,
    .height = 292,
    .draw = draw,
};
