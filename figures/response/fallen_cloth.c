// Cloth on a ball, and sheets on a column.
#include "kit/cloth_stills.h"
#include "kit/figures.h"

static const fig_cloth_still stills[] = {
    {.plan = {.scene = "sphere", .size = 35, .steps = 90}, .first = 88},
    {.plan = {.scene = "stack", .size = 14, .steps = 65}, .first = 63},
};

static void draw(fig_page *page, FILE *numbers)
{
    fig_draw_stills(page, numbers, 2, stills);
}

const fig_figure fig_fallen_cloth = {
    .name = "fallen-cloth",
    .title = "Cloth fallen on a ball, and five sheets on a column",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
