// In the plane a chain falls into a box.
#include "base/require.h"
#include "kit/cloth_run.h"
#include "kit/figures.h"
#include "kit/film.h"

#include <math.h>
#include <stdlib.h>

enum {
    LINKS = 240,
    STEPS = 144 ///< three for each frame of the film
};

static const double still = 0.5;

typedef struct scene {
    const fig_cloth_run *run;
    fig_cloth *cloth;
} scene;

static scene *make_scene(void)
{
    scene *s = malloc(sizeof *s);
    TF_REQUIRE(s);
    s->run = fig_cloth_run_of(&(fig_cloth_plan){
        .scene = "plane-chain", .size = LINKS, .steps = STEPS});
    s->cloth = fig_cloth_run_film(s->run, 0, 1);
    return s;
}

/// All frames of a film show the same run.
static const scene *the_scene(void)
{
    static scene *kept;
    if (!kept)
        kept = make_scene();
    return kept;
}

static void draw(fig_page *page, FILE *numbers)
{
    const scene *s = the_scene();
    double t = fig_film_time(page, numbers, still, -1);
    int step = (int)lround(t * STEPS);
    fig_box box = {60, 0, fig_page_width(page) - 120, fig_page_height(page)};
    fig_cloth_draw(s->cloth, page, box, step, &(fig_cloth_look){0});
    fig_number(numbers, "links", LINKS);
    fig_number(numbers, "step", step);
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "failsafe", fig_cloth_run_count(s->run, TF_FAILSAFE));
}

const fig_figure fig_chain_in_a_box = {
    .name = "chain-in-a-box",
    .title = "A chain falls into a box",
    .width = FIG_PAGE_WIDTH,
    .height = 216,
    .moves = true,
    .draw = draw,
};
