// A sheet half way in another one, where the curve cuts nothing: how the curve's
// length changes if one of them moves.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/tangle_picture.h"
#include "renderer/plot.h"

#include <stdlib.h>
#include <string.h>

enum {
    WAYS = 3,
    STEPS = 25
};

static const double most = 0.45;

static const struct {
    const char *key;
    fig_role role;
    double by[3];
} ways[WAYS] = {{"along", FIG_ROLE_CONTACT, {0, -1, 0}},
                {"across", FIG_ROLE_POINT, {1, 0, 0}},
                {"up", FIG_ROLE_EDGE, {0, 0, 1}}};

/// The length of the curve if the second part has moved.
static double length_after(const fig_tangle *tangle, const double by[3],
                           double way)
{
    const fig_some_mesh *mesh = &tangle->mesh;
    size_t size = 3 * (size_t)mesh->vertices * sizeof(double);
    double *x = malloc(size), length = 0;
    TF_REQUIRE(x);
    memcpy(x, mesh->x, size);
    fig_crossing_curves curves = fig_crossing_curves_find(mesh, x);
    for (int v = 0; v < mesh->vertices; v++)
        for (int k = 0; k < 3 && curves.part[v] == 1; k++)
            x[3 * (ptrdiff_t)v + k] += way * by[k];
    fig_crossing_curves_free(&curves);
    curves = fig_crossing_curves_find(mesh, x);
    for (int i = 0; i < curves.pieces.count; i++) {
        const tf_vector *at = curves.pieces.piece[i].at;
        length += fig_length(fig_difference(at[0], at[1]));
    }
    fig_crossing_curves_free(&curves);
    free(x);
    return length;
}

static void draw_way(fig_page *page, const fig_plot *plot,
                     const fig_tangle *tangle, int way, FILE *numbers)
{
    fig_point curve[STEPS];
    for (int i = 0; i < STEPS; i++) {
        double by = most * i / (STEPS - 1);
        curve[i] = (fig_point){by, length_after(tangle, ways[way].by, by)};
    }
    fig_plot_curve(
        page, plot, STEPS, curve,
        (fig_stroke){.paint = {.role = ways[way].role}, .width = 1.6});
    char key[32];
    snprintf(key, sizeof key, "shorter_%s", ways[way].key);
    fig_number(numbers, key, curve[0].y - curve[STEPS / 2].y);
    if (way == 0)
        fig_number(numbers, "length", curve[0].y);
}

static void draw_tangle(fig_page *page, const fig_tangle *tangle, fig_box box)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_tangle_draw_in(panel, tangle, tangle->mesh.x);
    const tf_vector end = {{0.013, -0.97, 0.011}};
    for (int i = 0; i < WAYS; i++) {
        tf_vector by = fig_vector_of(ways[i].by);
        fig_scene_arrow(fig_panel_scene(panel), end,
                        fig_combination(end, most, by), FIG_WIDTH_TUBE,
                        (fig_paint){.role = ways[i].role});
    }
}

static void name_line(fig_page *page, const fig_plot *plot, double x, double y,
                      const char *text, fig_role role)
{
    fig_point at = fig_plot_place(plot, x, y);
    fig_page_text(page, at.x, at.y, FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL,
                  role);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_tangle tangle = fig_tangle_make("half way in");
    draw_tangle(page, &tangle, (fig_box){0, 4, 160, 140});
    fig_plot plot = {.box = {216, 10, 150, 106},
                     .x = {0, most},
                     .y = {0, 1},
                     .name_x = "moved by",
                     .name_y = "length of the curve"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < WAYS; i++)
        draw_way(page, &plot, &tangle, i, numbers);
    name_line(page, &plot, 0.16, 0.93, "across it, or up", FIG_ROLE_INK);
    name_line(page, &plot, 0.16, 0.48, "along the curve", FIG_ROLE_CONTACT);
    int half = STEPS / 2;
    fig_number(numbers, "half", most * half / (STEPS - 1));
    fig_tangle_free(&tangle);
}

const fig_figure fig_contour_gradient = {
    .name = "contour-gradient",
    .title = "How a crossing curve shortens",
    .width = FIG_PAGE_WIDTH,
    .height = 150,
    .draw = draw,
};
