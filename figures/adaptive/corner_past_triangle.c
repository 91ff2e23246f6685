// A corner of a tetrahedron moves to the other side of the opposite triangle
// and passes beside it.
#include "kit/figures.h"
#include "kit/turning.h"

static void draw(fig_page *page, FILE *numbers)
{
    static const fig_turning beside = {
        .camera = {.azimuth = -20, .elevation = 34},
        .end = {0.5, 0.5, -3},
        .time = 0.8,
        .meeting = {0, 0, -1},
        .name = "edge on edge"};
    fig_turning_draw(page, numbers, &beside);
}

const fig_figure fig_corner_past_triangle = {
    .name = "corner-past-triangle",
    .title = "A tetrahedron's corner that passes the opposite triangle",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .moves = true,
    .draw = draw,
};
