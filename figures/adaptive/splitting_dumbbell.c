// A dumbbell whose grip is squeezed until it comes apart.
#include "kit/figures.h"
#include "kit/flow_film.h"

static void draw(fig_page *page, FILE *numbers)
{
    static fig_flow_film film = {
        .plan = {.scene = "dumbbell", .edge = 0.04, .steps = 150, .every = 3},
        .look = {.turned = true,
                 .azimuth = 0,
                 .elevation = 14,
                 .groundless = true},
        .still = 1};
    fig_flow_film_draw(
        &film, page,
        (fig_box){20, 4, fig_page_width(page) - 40, fig_page_height(page) - 8},
        numbers);
}

const fig_figure fig_splitting_dumbbell = {
    .name = "splitting-dumbbell",
    .title = "A dumbbell that comes apart",
    .width = FIG_PAGE_WIDTH,
    .height = 126,
    .moves = true,
    .draw = draw,
};
