// A ball in a flow that turns back, smoothed with care for its volume and
// without.
#include "flow/keep_volume.h"
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/flow_run.h"

#include <math.h>
#include <stdio.h>

enum {
    BALLS = 2,
    EVERY = 6,
    STEPS = 50 * EVERY
};

static const double still = 0.5;

/// Chooses the middle of a star, which is not on its level.
static bool choose_middle(tf_remesher *remesher, int vertex,
                          tf_vector *position)
{
    bool chosen = tf_keep_volume.choose_move(remesher, vertex, position);
    *position = tf_star_middle(remesher->surface, vertex);
    return chosen;
}

/// Both runs and, one after the other, their frames.
typedef struct both {
    fig_flow_run *run[BALLS];
    fig_cloth **cloth;
} both;

/// All frames of a film show the same runs.
static const both *the_balls(void)
{
    static both kept;
    tf_remesh_policy careless = tf_keep_volume;
    careless.choose_move = choose_middle;
    if (!kept.cloth) {
        for (int i = 0; i < BALLS; i++)
            kept.run[i] = fig_flow_run_new(
                &(fig_flow_plan){.scene = "enright",
                                 .edge = 0.03,
                                 .steps = STEPS,
                                 .every = EVERY,
                                 .policy = i == 0 ? &careless : NULL,
                                 .keep_topology = true});
        kept.cloth = fig_flow_run_films(BALLS, kept.run);
    }
    return &kept;
}

/// The volume in a frame, the first being 1.
static double volume_in(const fig_flow_run *run, int frame)
{
    return run->frame[frame].measures.volume / run->frame[0].measures.volume;
}

static void draw_ball(fig_page *page, fig_box box, const both *balls, int ball,
                      int frame)
{
    const fig_flow_run *run = balls->run[ball];
    const fig_cloth_look look = {
        .turned = true, .azimuth = 30, .elevation = 20, .groundless = true};
    fig_cloth_draw(balls->cloth[ball * run->frames + frame], page, box, 0,
                   &look);
    char text[64];
    snprintf(text, sizeof text, "volume %.1f %%", 100 * volume_in(run, frame));
    fig_page_caption(page, box, text);
}

static void draw(fig_page *page, FILE *numbers)
{
    const both *balls = the_balls();
    int last = balls->run[0]->frames - 1;
    double t = fig_film_time(page, numbers, still, -1);
    double width = fig_page_width(page) / BALLS;
    for (int i = 0; i < BALLS; i++)
        draw_ball(page,
                  (fig_box){width * i, 0, width, fig_page_height(page) - 16},
                  balls, i, (int)lround(t * last));
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "triangles",
               balls->run[0]->frame[0].measures.triangles);
    fig_number(numbers, "left", 100 * volume_in(balls->run[0], last));
    fig_number(numbers, "error", fabs(volume_in(balls->run[1], last) - 1));
}

const fig_figure fig_enright_volume = {
    .name = "enright-volume",
    .title = "A ball that loses its volume, and one that keeps it",
    .width = FIG_PAGE_WIDTH,
    .height = 148,
    .moves = true,
    .draw = draw,
};
