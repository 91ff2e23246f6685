#include "kit/tangle_picture.h"

enum {
    COLORS = 4
};

fig_role fig_part_role(const fig_crossing_curves *curves, int vertex)
{
    static const fig_role roles[COLORS] = {FIG_ROLE_TRIANGLE, FIG_ROLE_EDGE,
                                           FIG_ROLE_POINT, FIG_ROLE_OTHER_EDGE};
    return roles[curves->part[vertex] % COLORS];
}

typedef struct painted {
    const fig_some_mesh *mesh;
    const fig_crossing_curves *curves;
} painted;

static bool paint_part(const void *context, int triangle, fig_paint *paint)
{
    const painted *p = context;
    int vertex = p->mesh->triangle[3 * (ptrdiff_t)triangle];
    *paint = (fig_paint){.role = fig_part_role(p->curves, vertex)};
    return true;
}

size_t fig_tangle_draw_in(fig_panel *panel, const fig_tangle *tangle,
                          const double x[])
{
    const fig_some_mesh *mesh = &tangle->mesh;
    fig_crossing_curves curves = fig_crossing_curves_find(mesh, x);
    fig_scene *scene = fig_panel_scene(panel);
    fig_panel_look(panel, tangle->camera);
    fig_panel_margin(panel, 5);
    for (int v = 0; v < mesh->vertices; v++)
        fig_scene_reach(scene, fig_vector_of(mesh->x + 3 * (ptrdiff_t)v));
    fig_draw_smooth_mesh(scene, mesh, x, 0.2, paint_part,
                         &(painted){mesh, &curves});
    fig_curve_pieces_draw(scene, &curves.pieces, 1.8);
    size_t crossings = curves.crossings;
    fig_crossing_curves_free(&curves);
    return crossings;
}

size_t fig_tangle_draw(fig_page *page, fig_box box, const fig_tangle *tangle,
                       const double x[])
{
    return fig_tangle_draw_in(fig_page_panel(page, box), tangle, x);
}
