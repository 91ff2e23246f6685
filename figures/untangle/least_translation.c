// How far a ball has to be moved in each direction until it is clear of another
// surface: one of the ways to move parts apart.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/tangle_picture.h"

#include <stdlib.h>
#include <string.h>

enum {
    DIRECTIONS = 26,
    HALVINGS = 20
};

static const double most = 2.4;

/// The crossings if the second part is moved.
static size_t count_moved(const fig_tangle *tangle, const int part[],
                          tf_vector by, double x[])
{
    const fig_some_mesh *mesh = &tangle->mesh;
    memcpy(x, mesh->x, 3 * (size_t)mesh->vertices * sizeof *x);
    for (int v = 0; v < mesh->vertices; v++)
        for (int k = 0; k < 3 && part[v] == 1; k++)
            x[3 * (ptrdiff_t)v + k] += by.x[k];
    fig_crossing_curves curves = fig_crossing_curves_find(mesh, x);
    size_t count = curves.crossings;
    fig_crossing_curves_free(&curves);
    return count;
}

/// The shortest way out in a direction, if there is one way in it.
static double find_way(const fig_tangle *tangle, const int part[],
                       tf_vector direction, double x[])
{
    double low = 0, high = most;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = (low + high) / 2;
        bool clear = count_moved(tangle, part,
                                 tf_vector_scaled(middle, direction), x) == 0;
        *(clear ? &high : &low) = middle;
    }
    return high;
}

/// The i-th of the directions to the neighbors of a cube.
static tf_vector direction_of(int i)
{
    i += i >= DIRECTIONS / 2;
    int middle = i / 3 % 3, high = i / 9;
    tf_vector way = {{i % 3 - 1, middle - 1, high - 1}};
    return fig_normalized(way);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_tangle tangle = fig_tangle_make("arm in torso");
    const fig_some_mesh *mesh = &tangle.mesh;
    fig_crossing_curves curves = fig_crossing_curves_find(mesh, mesh->x);
    double *x = malloc(3 * (size_t)mesh->vertices * sizeof *x);
    double way[DIRECTIONS];
    int least = 0, greatest = 0;
    TF_REQUIRE(x);
    for (int i = 0; i < DIRECTIONS; i++) {
        way[i] = find_way(&tangle, curves.part, direction_of(i), x);
        least = way[i] < way[least] ? i : least;
        greatest = way[i] > way[greatest] ? i : greatest;
    }
    double height = fig_page_height(page);
    fig_box left = {0, 4, 190, height - 22}, right = {194, 4, 190, height - 22};
    fig_panel *panel = fig_page_panel(page, left);
    fig_tangle_draw_in(panel, &tangle, mesh->x);
    const tf_vector middle = {{1.15, 0.03, 0.65}};
    for (int i = 0; i < DIRECTIONS; i++)
        fig_scene_arrow(
            fig_panel_scene(panel), middle,
            fig_combination(middle, 0.6 * way[i], direction_of(i)),
            i == least ? FIG_WIDTH_TUBE : FIG_WIDTH_THIN,
            (fig_paint){.role = i == least ? FIG_ROLE_CONTACT : FIG_ROLE_INK});
    fig_page_caption(page, left, "26 ways out");
    count_moved(&tangle, curves.part,
                tf_vector_scaled(way[least], direction_of(least)), x);
    fig_tangle_draw(page, right, &tangle, x);
    fig_page_caption(page, right, "the shortest");
    fig_number(numbers, "directions", DIRECTIONS);
    fig_number(numbers, "least", way[least]);
    fig_number(numbers, "greatest", way[greatest]);
    free(x);
    fig_crossing_curves_free(&curves);
    fig_tangle_free(&tangle);
}

const fig_figure fig_least_translation = {
    .name = "least-translation",
    .title = "Ways out of a body, and the shortest of them",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
