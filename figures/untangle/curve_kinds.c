// Four tangles, and the curves along which they intersect themselves.
#include "kit/figures.h"
#include "kit/tangle_picture.h"

enum {
    PANELS = 4
};

static const struct {
    const char *name, *key, *title;
} scenes[PANELS] = {
    {"cloth and ball", "closed", "closed"},
    {"sheets at 10", "border", "from border to border"},
    {"half way in", "inside", "ends inside"},
    {"fold", "itself", "with itself"},
};

static void print_numbers(FILE *numbers, const char *scene,
                          const fig_tangle *tangle)
{
    char key[48];
    fig_crossing_curves curves =
        fig_crossing_curves_find(&tangle->mesh, tangle->mesh.x);
    snprintf(key, sizeof key, "crossings_%s", scene);
    fig_number(numbers, key, (double)curves.crossings);
    snprintf(key, sizeof key, "regions_%s", scene);
    fig_number(numbers, key, curves.regions);
    snprintf(key, sizeof key, "parts_%s", scene);
    fig_number(numbers, key, curves.parts);
    fig_crossing_curves_free(&curves);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / PANELS;
    for (int i = 0; i < PANELS; i++) {
        fig_box box = {width * i, 0, width, fig_page_height(page) - 16};
        fig_tangle tangle = fig_tangle_make(scenes[i].name);
        fig_tangle_draw(page, box, &tangle, tangle.mesh.x);
        fig_page_caption(page, box, scenes[i].title);
        print_numbers(numbers, scenes[i].key, &tangle);
        fig_tangle_free(&tangle);
    }
}

const fig_figure fig_curve_kinds = {
    .name = "curve-kinds",
    .title = "Curves along which surfaces intersect themselves",
    .width = FIG_PAGE_WIDTH,
    .height = 110,
    .draw = draw,
};
