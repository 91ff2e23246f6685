// A knot that is pulled tight, a curtain that is drawn through a ring, and a
// flag.
#include "kit/cloth_stills.h"
#include "kit/figures.h"

static const fig_cloth_still stills[] = {
    {.plan = {.scene = "knot", .size = 5, .steps = 540}, .first = 538},
    {.plan = {.scene = "curtain", .size = 40, .steps = 600}, .first = 598},
    {.plan = {.scene = "flag", .size = 32, .steps = 300}, .first = 298},
};

static void draw(fig_page *page, FILE *numbers)
{
    fig_draw_stills(page, numbers, 3, stills);
}

const fig_figure fig_pulled_cloth = {
    .name = "pulled-cloth",
    .title = "A knot, a curtain and a flag",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .draw = draw,
};
