// A plate with a hole before its remeshing, and in its course.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/remeshed.h"

#include "renderer/plot.h"

#include <math.h>

enum {
    AROUND = 48,
    ROUNDS = 5
};

static const double edge = 0.1;

/// The remeshing of the plate, done once.
static const fig_remeshing *remeshing_of_plate(void)
{
    static fig_remeshing all;
    if (all.stages == 0) {
        fig_some_mesh plate = fig_plate_with_hole(AROUND);
        fig_remesh(&plate, edge, ROUNDS, false, &all);
        fig_some_mesh_free(&plate);
    }
    return &all;
}

static void draw_stage(fig_page *page, fig_box box, const fig_some_mesh *mesh)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 24, .elevation = 42});
    fig_panel_margin(panel, 5);
    fig_draw_triangles(fig_panel_scene(panel), mesh,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE});
    char count[FIG_GROUPED], text[FIG_GROUPED + 16];
    fig_plot_grouped(mesh->triangles, count);
    snprintf(text, sizeof text, "%s triangles", count);
    fig_page_caption(page, box, text);
}

static void print_numbers(FILE *numbers, const fig_remeshing *all)
{
    const fig_some_mesh *first = &all->stage[0];
    const fig_some_mesh *last = &all->stage[all->stages - 1];
    fig_number(numbers, "rounds", ROUNDS);
    fig_number(numbers, "triangles_before", first->triangles);
    fig_number(numbers, "triangles_after", last->triangles);
    fig_number(numbers, "angle_before", fig_least_angle(first));
    fig_number(numbers, "angle_after", fig_least_angle(last));
}

static void draw(fig_page *page, FILE *numbers)
{
    const fig_remeshing *all = remeshing_of_plate();
    double width = fig_page_width(page) / 2,
           height = fig_page_height(page) - 16;
    double t = fig_film_time(page, numbers, 1, -1);
    int stage = (int)lround(t * (all->stages - 1));
    draw_stage(page, (fig_box){0, 0, width, height}, &all->stage[0]);
    draw_stage(page, (fig_box){width, 0, width, height}, &all->stage[stage]);
    print_numbers(numbers, all);
}

const fig_figure fig_remeshed_plate = {
    .name = "remeshed-plate",
    .title = "A plate in the course of its remeshing",
    .width = FIG_PAGE_WIDTH,
    .height = 166,
    .moves = true,
    .draw = draw,
};
