// How many operations each round of a remeshing does.
#include "kit/figures.h"
#include "kit/remeshed.h"

#include "remesh/policy.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    AROUND = 48
};

static const double edge = 0.1;

static const struct {
    const char *name;
    fig_role role;
} operations[TF_REMESH_PASSES] = {
    [TF_SPLIT] = {"splits", FIG_ROLE_EDGE},
    [TF_COLLAPSE] = {"collapses", FIG_ROLE_CONTACT},
    [TF_FLIP] = {"flips", FIG_ROLE_OTHER_EDGE},
    [TF_SMOOTH] = {"moves", FIG_ROLE_TRIANGLE},
};

static double done_in_round(const fig_remeshing *all, int round,
                            tf_operation operation)
{
    double before =
        round == 0 ? 0 : fig_remesh_done(&all->report[round - 1], operation);
    return fig_remesh_done(&all->report[round], operation) - before;
}

static void draw_operation(fig_page *page, const fig_plot *plot,
                           const fig_remeshing *all, tf_operation operation)
{
    fig_point at[FIG_REMESH_ROUNDS];
    fig_role role = operations[operation].role;
    for (int i = 0; i < FIG_REMESH_ROUNDS; i++)
        at[i] = (fig_point){i + 1, fmax(0.5, done_in_round(all, i, operation))};
    fig_plot_curve(page, plot, FIG_REMESH_ROUNDS, at,
                   (fig_stroke){.paint = {.role = role}});
    // A round that does none is below the scale.
    for (int i = 0; i < FIG_REMESH_ROUNDS; i++)
        if (at[i].y >= 1)
            fig_plot_dot(page, plot, at[i].x, at[i].y, 4, role);
    fig_plot_key(page, 290, 24 + 16.0 * (int)operation,
                 operations[operation].name, role);
}

static void draw(fig_page *page, FILE *numbers)
{
    static fig_remeshing all;
    if (all.stages == 0) {
        fig_some_mesh plate = fig_plate_with_hole(AROUND);
        fig_remesh(&plate, edge, FIG_REMESH_ROUNDS, false, &all);
        fig_some_mesh_free(&plate);
    }
    fig_plot plot = {.box = {46, 12, 226, 128},
                     .x = {0.5, FIG_REMESH_ROUNDS + 0.5},
                     .y = {1, 1e4},
                     .log_y = true,
                     .name_x = "round",
                     .name_y = "operations"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < TF_REMESH_PASSES; i++)
        draw_operation(page, &plot, &all, (tf_operation)i);
    fig_number(numbers, "rounds", FIG_REMESH_ROUNDS);
    for (int i = 0; i < TF_REMESH_PASSES; i++)
        fig_number(numbers, operations[i].name,
                   done_in_round(&all, FIG_REMESH_ROUNDS - 1, (tf_operation)i));
}

const fig_figure fig_remeshing_rounds = {
    .name = "remeshing-rounds",
    .title = "The operations in each round of a remeshing",
    .width = FIG_PAGE_WIDTH,
    .height = 176,
    .draw = draw,
};
