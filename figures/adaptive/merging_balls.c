// Two balls that are pressed together and merge.
#include "kit/figures.h"
#include "kit/flow_film.h"

static void draw(fig_page *page, FILE *numbers)
{
    static fig_flow_film film = {
        .plan = {.scene = "spheres", .edge = 0.05, .steps = 300, .every = 6},
        .look = {.turned = true,
                 .azimuth = -30,
                 .elevation = 18,
                 .groundless = true},
        .still = 0.22};
    fig_flow_film_draw(
        &film, page,
        (fig_box){40, 4, fig_page_width(page) - 80, fig_page_height(page) - 8},
        numbers);
}

const fig_figure fig_merging_balls = {
    .name = "merging-balls",
    .title = "Two balls that merge",
    .width = FIG_PAGE_WIDTH,
    .height = 182,
    .moves = true,
    .draw = draw,
};
