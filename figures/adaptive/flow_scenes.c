// A ball in turbulence, a star that grows, and sheets that are rolled up.
#include "kit/figures.h"
#include "kit/flow_run.h"

enum {
    SCENES = 3
};

static const fig_flow_plan plans[SCENES] = {
    {.scene = "turbulence", .edge = 0.06, .steps = 300, .every = 300},
    {.scene = "star", .edge = 0.06, .steps = 80, .every = 80},
    {.scene = "sheets", .edge = 0.08, .steps = 200, .every = 200},
};

/// The surface of a scene after its last step, alone in its box.
typedef struct still {
    const fig_flow_run *run;
    fig_cloth **cloth; ///< one
} still;

static fig_flow_frame *last_frame(const fig_flow_run *run)
{
    return &run->frame[run->frames - 1];
}

static still still_of(const fig_flow_plan *plan)
{
    fig_flow_run *run = fig_flow_run_new(plan);
    fig_flow_run last = {.frames = 1, .frame = last_frame(run)};
    return (still){run, fig_flow_run_films(1, (fig_flow_run *[]){&last})};
}

static void print_still(FILE *numbers, const fig_flow_plan *plan,
                        const still *s)
{
    char key[64];
    snprintf(key, sizeof key, "step_%s", plan->scene);
    fig_number(numbers, key, plan->steps);
    snprintf(key, sizeof key, "triangles_%s", plan->scene);
    fig_number(numbers, key, last_frame(s->run)->measures.triangles);
}

static void draw(fig_page *page, FILE *numbers)
{
    static still stills[SCENES];
    static const fig_cloth_look look = {
        .turned = true, .azimuth = 30, .elevation = 25, .groundless = true};
    double width = fig_page_width(page) / SCENES;
    for (int i = 0; i < SCENES; i++) {
        fig_box box = {width * i, 0, width, fig_page_height(page) - 16};
        if (!stills[i].cloth)
            stills[i] = still_of(&plans[i]);
        fig_cloth_draw(stills[i].cloth[0], page, box, 0, &look);
        fig_page_caption(page, box, plans[i].scene);
        print_still(numbers, &plans[i], &stills[i]);
    }
}

const fig_figure fig_flow_scenes = {
    .name = "flow-scenes",
    .title = "Surfaces in three flows: turbulence, star and sheets",
    .width = FIG_PAGE_WIDTH,
    .height = 150,
    .draw = draw,
};
