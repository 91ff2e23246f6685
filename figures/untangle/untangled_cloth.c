// Cloth that a ball has got into comes out of it, round by round.
#include "base/require.h"
#include "kit/cloth.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/untangled.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdlib.h>

enum {
    FRAMES = 49
};

/// Where on its way through the states a time is.
static double state_at(const fig_untangling *all, double t)
{
    return t * (all->states - 1);
}

static void add_between(fig_cloth *cloth, const fig_untangling *all, double at)
{
    int count = all->tangle.mesh.vertices;
    int i = (int)fmin(floor(at), all->states - 2);
    double *x = malloc(3 * (size_t)count * sizeof *x);
    TF_REQUIRE(x);
    for (int k = 0; k < 3 * count; k++)
        x[k] = all->state[i].x[k] +
               (at - i) * (all->state[i + 1].x[k] - all->state[i].x[k]);
    TF_REQUIRE(fig_cloth_add(cloth, count, x));
    free(x);
}

static const fig_cloth *film_of(const fig_untangling *all)
{
    static fig_cloth *cloth;
    static tf_surface *surface;
    if (cloth)
        return cloth;
    tf_mesh mesh = fig_mesh_in_space(&all->tangle.mesh);
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    cloth = fig_cloth_new(surface, 3);
    TF_REQUIRE(cloth);
    for (int i = 0; i < FRAMES; i++)
        add_between(cloth, all, state_at(all, (double)i / (FRAMES - 1)));
    TF_REQUIRE(fig_cloth_end(cloth));
    return cloth;
}

static void draw_counts(fig_page *page, fig_box box, const fig_untangling *all,
                        double t)
{
    fig_point curve[FIG_UNTANGLING_STATES];
    int last = all->states - 1, most = all->rounds[last];
    fig_plot plot = {.box = box,
                     .x = {0, most},
                     .y = {0, (double)all->state[0].report.left},
                     .name_x = "rounds",
                     .name_y = "crossings",
                     .ticks_y = 4};
    fig_plot_frame(page, &plot);
    for (int i = 0; i <= last; i++)
        curve[i] =
            (fig_point){all->rounds[i], (double)all->state[i].report.left};
    fig_plot_curve(page, &plot, last + 1, curve,
                   (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT}});
    for (int i = 0; i <= last; i++)
        fig_plot_dot(page, &plot, curve[i].x, curve[i].y, 3.2,
                     FIG_ROLE_CONTACT);
    int now = (int)fmin(floor(state_at(all, t)), last);
    fig_plot_dot(page, &plot, curve[now].x, curve[now].y, FIG_WIDTH_BALL,
                 FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    const fig_untangling *all = fig_untangling_of("cloth and ball");
    double t = fig_film_time(page, numbers, 1.0 / (FIG_FILM_FRAMES - 1), -1);
    double height = fig_page_height(page);
    fig_box box = {0, 2, 238, height - 4};
    fig_cloth_draw(film_of(all), page, box, (int)lrint(t * (FRAMES - 1)),
                   &(fig_cloth_look){.turned = true,
                                     .azimuth = 25,
                                     .elevation = 27,
                                     .groundless = true});
    draw_counts(page, (fig_box){284, 14, 92, height - 14 - FIG_PLOT_ROOM}, all,
                t);
    const tf_untangle_report *report = &all->state[all->states - 1].report;
    fig_number(numbers, "vertices", all->tangle.mesh.vertices);
    fig_number(numbers, "before", (double)report->before);
    fig_number(numbers, "left", (double)report->left);
    fig_number(numbers, "rounds", report->rounds);
    fig_number(numbers, "moved", report->moved);
    fig_number(numbers, "farthest", report->farthest / report->edge);
    fig_number(numbers, "mean", report->mean / report->edge);
    fig_number(numbers, "found", report->found / report->edge);
    fig_number(numbers, "deviation", report->deviation / report->edge);
}

const fig_figure fig_untangled_cloth = {
    .name = "untangled-cloth",
    .title = "Cloth comes out of a ball",
    .width = FIG_PAGE_WIDTH,
    .height = 150,
    .moves = true,
    .draw = draw,
};
