// Cloth on a ball, and sheets on a column.
#include "kit/cloth_stills.h"
#include "kit/figures.h"

static const fig_cloth_still stills[] = {
    {.plan = {.scene = "sphere", .size = 48, .steps = 140}, .first = 138},
    {.plan = {.scene = "stack", .size = 28, .steps = 85}, .first = 83},
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
