// What became of the tangles that are measured.
#include "kit/figures.h"
#include "kit/tangle_picture.h"
#include "kit/untangled.h"

enum {
    COLUMNS = 4,
    ROWS = 3
};

static void print_number(FILE *numbers, int i, const char *what, double value)
{
    char key[32];
    snprintf(key, sizeof key, "%s_%d", what, i);
    fig_number(numbers, key, value);
}

static void draw_tangle(fig_page *page, int i, FILE *numbers)
{
    double width = fig_page_width(page) / COLUMNS,
           height = fig_page_height(page) / ROWS;
    int row = i / COLUMNS;
    fig_box box = {i % COLUMNS * width, row * height, width, height - 15};
    fig_tangle tangle = fig_tangle_make(fig_tangle_name(i));
    fig_untangled untangled = fig_untangle(&tangle, 0, 0);
    fig_tangle_draw(page, box, &tangle, untangled.x);
    fig_page_caption(page, box, fig_tangle_name(i));
    print_number(numbers, i, "before", (double)untangled.report.before);
    print_number(numbers, i, "left", (double)untangled.report.left);
    fig_untangled_free(&untangled);
    fig_tangle_free(&tangle);
}

static void draw(fig_page *page, FILE *numbers)
{
    int i = 0;
    while (fig_tangle_name(i))
        draw_tangle(page, i++, numbers);
    fig_number(numbers, "tangles", i);
}

const fig_figure fig_untangled_tangles = {
    .name = "untangled-tangles",
    .title = "The twelve surfaces, untangled",
    .width = FIG_PAGE_WIDTH,
    .height = 330,
    .draw = draw,
};
