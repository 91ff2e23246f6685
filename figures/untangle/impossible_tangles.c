// What cannot end clear: a Klein bottle, sheets with linked borders that are fixed,
// and what is fixed altogether.
#include "kit/figures.h"
#include "kit/tangle_picture.h"
#include "kit/untangled.h"

#include "base/require.h"

#include <stdlib.h>

enum {
    PANELS = 3
};

static const struct {
    const char *name, *key, *title;
    bool borders, all; ///< what is fixed
} scenes[PANELS] = {
    {"Klein bottle", "bottle", "a Klein bottle", false, false},
    {"half way in", "linked", "both borders fixed", true, false},
    {"sheets at 10", "fixed", "all fixed", true, true},
};

/// How many triangles have both vertices.
static int count_sides(const fig_some_mesh *mesh, int a, int b)
{
    int count = 0;
    for (int t = 0; t < mesh->triangles; t++) {
        const int *v = mesh->triangle + 3 * (ptrdiff_t)t;
        int shared = 0;
        for (int i = 0; i < 3; i++)
            shared += v[i] == a || v[i] == b;
        count += shared == 2;
    }
    return count;
}

static void fix_borders(fig_tangle *tangle)
{
    const fig_some_mesh *mesh = &tangle->mesh;
    for (int c = 0; c < 3 * mesh->triangles; c++) {
        int a = mesh->triangle[c];
        int b = mesh->triangle[c % 3 == 2 ? c - 2 : c + 1];
        if (count_sides(mesh, a, b) == 1)
            tangle->fixed[a] = tangle->fixed[b] = true;
    }
}

static void fix(fig_tangle *tangle, bool borders, bool all)
{
    size_t vertices = (size_t)tangle->mesh.vertices;
    tangle->fixed = calloc(vertices, sizeof(bool));
    TF_REQUIRE(tangle->fixed);
    if (borders)
        fix_borders(tangle);
    for (size_t v = 0; v < vertices && all; v++)
        tangle->fixed[v] = true;
}

static void print_number(FILE *numbers, int i, const char *what, double value)
{
    char key[32];
    snprintf(key, sizeof key, "%s_%s", what, scenes[i].key);
    fig_number(numbers, key, value);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / PANELS;
    for (int i = 0; i < PANELS; i++) {
        fig_box box = {width * i, 0, width, fig_page_height(page) - 16};
        fig_tangle tangle = fig_tangle_make(scenes[i].name);
        fix(&tangle, scenes[i].borders, scenes[i].all);
        fig_untangled untangled = fig_untangle(&tangle, 0, 0);
        fig_tangle_draw(page, box, &tangle, untangled.x);
        fig_page_caption(page, box, scenes[i].title);
        print_number(numbers, i, "before", (double)untangled.report.before);
        print_number(numbers, i, "left", (double)untangled.report.left);
        print_number(numbers, i, "beyond", (double)untangled.report.beyond);
        fig_untangled_free(&untangled);
        fig_tangle_free(&tangle);
    }
}

const fig_figure fig_impossible_tangles = {
    .name = "impossible-tangles",
    .title = "Surfaces that no untangling clears",
    .width = FIG_PAGE_WIDTH,
    .height = 130,
    .draw = draw,
};
