// Cloth on a ball, and sheets on a column.
#include "cloth_stills.h"
#include "figures.h"

static const fig_cloth_still stills[] = {
    {.plan = {.scene = "sphere", .size = 16, .steps = 90}, .first = 88},
    {.plan = {.scene = "stack", .size = 8, .steps = 75}, .first = 73},
};

static void draw(fig_page *page, FILE *numbers)
{
    fig_draw_stills(page, numbers, 2, stills);
}

const fig_figure fig_fallen_cloth = {
    .name = "fallen-cloth",
    .title = "Cloth that has fallen",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
