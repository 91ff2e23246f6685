// The regions into which crossing curves cut the parts of a surface, which are
// drawn one above the other.
#include "kit/figures.h"
#include "kit/tangle_picture.h"

#include <stdlib.h>
#include <string.h>

enum {
    PANELS = 3
};

static const struct {
    const char *name, *key, *title;
    double lift; ///< of the second part
} scenes[PANELS] = {
    {"cloth and ball", "ball", "a cap and a disk are wrong", 1.3},
    {"sheets at 10", "sheets", "halves, and a slit", 1.1},
    {"half way in", "half", "nothing is cut", 1.5},
};

typedef struct parts {
    const fig_some_mesh *mesh;
    fig_crossing_curves curves;
    double lift;
} parts;

static double lift_of(const parts *p, int vertex)
{
    return p->curves.part[vertex] == 0 ? 0 : p->lift;
}

/// The region of most of its corners decides.
static bool paint_region(const void *context, int triangle, fig_paint *paint)
{
    const parts *p = context;
    const int *v = p->mesh->triangle + 3 * (ptrdiff_t)triangle;
    int wrong = 0;
    for (int i = 0; i < 3; i++)
        wrong += p->curves.wrong[v[i]];
    *paint = (fig_paint){.role = wrong >= 2 ? FIG_ROLE_POINT
                                            : fig_part_role(&p->curves, v[0])};
    return true;
}

/// The curves on both of the parts that they are on.
static void draw_curves(fig_scene *scene, const parts *p)
{
    for (int i = 0; i < p->curves.pieces.count; i++)
        for (int k = 0; k < 2; k++) {
            const fig_curve_piece *piece = &p->curves.pieces.piece[i];
            tf_vector by = {{0, 0, lift_of(p, piece->vertex[k])}};
            fig_scene_tube(scene, fig_sum(piece->at[0], by),
                           fig_sum(piece->at[1], by), 1.8,
                           (fig_paint){.role = FIG_ROLE_CONTACT});
        }
}

static void draw_parts(fig_page *page, fig_box box, const fig_tangle *tangle,
                       const parts *p)
{
    size_t size = 3 * (size_t)p->mesh->vertices * sizeof(double);
    double *x = malloc(size);
    fig_panel *panel = fig_page_panel(page, box);
    fig_scene *scene = fig_panel_scene(panel);
    fig_panel_look(panel, tangle->camera);
    fig_panel_margin(panel, 5);
    if (!x) {
        fig_scene_fail(scene);
        return;
    }
    memcpy(x, p->mesh->x, size);
    for (int v = 0; v < p->mesh->vertices; v++)
        x[3 * (ptrdiff_t)v + 2] += p->curves.part[v] == 0 ? 0 : p->lift;
    fig_draw_smooth_mesh(scene, p->mesh, x, 0.2, paint_region, p);
    draw_curves(scene, p);
    free(x);
}

static void print_number(FILE *numbers, int scene, const char *what,
                         double value)
{
    char key[48];
    snprintf(key, sizeof key, "%s_%s", scenes[scene].key, what);
    fig_number(numbers, key, value);
}

static void draw_scene(fig_page *page, fig_box box, int i, FILE *numbers)
{
    fig_tangle tangle = fig_tangle_make(scenes[i].name);
    const fig_some_mesh *mesh = &tangle.mesh;
    parts p = {mesh, fig_crossing_curves_find(mesh, mesh->x), scenes[i].lift};
    draw_parts(page, box, &tangle, &p);
    fig_page_caption(page, box, scenes[i].title);
    print_number(numbers, i, "crossings", (double)p.curves.crossings);
    print_number(numbers, i, "regions", p.curves.regions);
    print_number(numbers, i, "vertices", mesh->vertices);
    print_number(numbers, i, "wrong", p.curves.wrongs);
    fig_crossing_curves_free(&p.curves);
    fig_tangle_free(&tangle);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / PANELS;
    for (int i = 0; i < PANELS; i++)
        draw_scene(page,
                   (fig_box){width * i, 0, width, fig_page_height(page) - 16},
                   i, numbers);
}

const fig_figure fig_cut_regions = {
    .name = "cut-regions",
    .title = "Regions into which crossing curves cut surfaces",
    .width = FIG_PAGE_WIDTH,
    .height = 165,
    .draw = draw,
};
