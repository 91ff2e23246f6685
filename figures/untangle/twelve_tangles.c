// The tangles that are measured, with their curves.
#include "kit/figures.h"
#include "kit/tangle_picture.h"

enum {
    COLUMNS = 4,
    ROWS = 3
};

static void draw_tangle(fig_page *page, int i, FILE *numbers)
{
    double width = fig_page_width(page) / COLUMNS,
           height = fig_page_height(page) / ROWS;
    int row = i / COLUMNS;
    fig_box box = {i % COLUMNS * width, row * height, width, height - 15};
    fig_tangle tangle = fig_tangle_make(fig_tangle_name(i));
    size_t crossings = fig_tangle_draw(page, box, &tangle, tangle.mesh.x);
    char key[24];
    snprintf(key, sizeof key, "crossings_%d", i);
    fig_number(numbers, key, (double)crossings);
    fig_page_caption(page, box, fig_tangle_name(i));
    fig_tangle_free(&tangle);
}

static void draw(fig_page *page, FILE *numbers)
{
    int i = 0;
    while (fig_tangle_name(i))
        draw_tangle(page, i++, numbers);
    fig_number(numbers, "tangles", i);
}

const fig_figure fig_twelve_tangles = {
    .name = "twelve-tangles",
    .title = "Twelve surfaces that intersect themselves",
    .width = FIG_PAGE_WIDTH,
    .height = 330,
    .draw = draw,
};
