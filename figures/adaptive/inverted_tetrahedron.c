// A corner of a tetrahedron moves through the opposite triangle.
#include "kit/figures.h"
#include "kit/turning.h"

static void draw(fig_page *page, FILE *numbers)
{
    static const fig_turning through = {
        .camera = {.azimuth = 22, .elevation = 14},
        .end = {-2, -2, -2},
        .time = 4.0 / 9,
        .meeting = {-1.0 / 3, -1.0 / 3, -1.0 / 3},
        .name = "corner on triangle"};
    fig_turning_draw(page, numbers, &through);
}

const fig_figure fig_inverted_tetrahedron = {
    .name = "inverted-tetrahedron",
    .title = "A tetrahedron that is turned inside out",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .moves = true,
    .draw = draw,
};
