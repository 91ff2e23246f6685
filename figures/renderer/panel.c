#include "base/require.h"
#include "renderer/list.h"
#include "renderer/page_parts.h"

#include <stdlib.h>

enum {
    TURNS = 24
}; ///< azimuths to which a panel that may be turned is fitted

/// A panel to draw on when there is no memory for another one is the last one
/// that there is; without any, there is nothing to go on with.
static fig_panel *add_panel(fig_page *page)
{
    fig_panel *panel = calloc(1, sizeof *panel);
    if (panel == NULL ||
        !fig_list_room(&page->panels, page->panel_count, 1, &page->panel_room,
                       sizeof(fig_panel *))) {
        free(panel);
        fig_page_note(page, FIG_NO_MEMORY);
        TF_REQUIRE(page->panel_count > 0);
        return page->panels[page->panel_count - 1];
    }
    page->panels[page->panel_count++] = panel;
    return panel;
}

fig_panel *fig_page_panel(fig_page *page, fig_box box)
{
    TF_REQUIRE(box.width > 0 && box.height > 0);
    fig_panel *panel = add_panel(page);
    panel->page = page;
    panel->box = box;
    panel->margin = FIG_FIT_MARGIN;
    fig_page_add_mark(page, (fig_mark){.kind = FIG_MARK_PANEL, .panel = panel});
    return panel;
}

fig_scene *fig_panel_scene(fig_panel *panel)
{
    return &panel->scene;
}

void fig_panel_look(fig_panel *panel, fig_camera camera)
{
    panel->camera = camera;
}

void fig_panel_margin(fig_panel *panel, double margin)
{
    panel->margin = margin;
}

void fig_panel_fix(fig_panel *panel)
{
    panel->fixed = true;
}

/// Where points are as the scene turns once around the up axis through the
/// middle of their bounds.  NULL if there is no memory.
static tf_vector *turned_points(const fig_scene *scene)
{
    int count = scene->reached_count;
    tf_vector *all = malloc((size_t)count * TURNS * sizeof *all);
    tf_vector middle = fig_middle_of(count, scene->reached);
    for (int i = 0; all != NULL && i < count * TURNS; i++) {
        tf_vector at = scene->reached[i / TURNS];
        double x = at.x[0] - middle.x[0], y = at.x[1] - middle.x[1];
        double turn = 6.283185307179586 * (i % TURNS) / TURNS;
        all[i] =
            (tf_vector){{middle.x[0] + x * cos(turn) - y * sin(turn),
                         middle.x[1] + x * sin(turn) + y * cos(turn), at.x[2]}};
    }
    return all;
}

/// Fit a camera that turns: as far off for every azimuth.
static fig_camera fit_turning(const fig_panel *panel, const fig_camera *camera)
{
    tf_vector *all = turned_points(&panel->scene);
    if (all == NULL) {
        fig_page_note(panel->page, FIG_NO_MEMORY);
        return *camera;
    }
    fig_camera fitted =
        fig_camera_fit(camera, TURNS * panel->scene.reached_count, all,
                       panel->box.width, panel->box.height, panel->margin);
    free(all);
    return fitted;
}

fig_view fig_panel_view(const fig_panel *panel)
{
    const fig_page_options *options = &panel->page->options;
    fig_camera camera = panel->camera;
    bool turning = options->turned && !panel->fixed;
    if (turning) {
        camera.azimuth = options->azimuth;
        camera.elevation = options->elevation;
    }
    bool fit = camera.height == 0 && panel->scene.reached_count > 0;
    if (fit && turning)
        camera = fit_turning(panel, &camera);
    else if (fit)
        camera = fig_camera_fit(&camera, panel->scene.reached_count,
                                panel->scene.reached, panel->box.width,
                                panel->box.height, panel->margin);
    if (camera.height == 0)
        camera.height = 1;
    return fig_view_of(&camera, panel->box);
}

fig_point fig_panel_project(const fig_panel *panel, tf_vector world)
{
    fig_view view = fig_panel_view(panel);
    return fig_view_project(&view, world);
}

fig_point fig_page_point(const fig_panel *panel, tf_vector at)
{
    return panel != NULL ? fig_panel_project(panel, at)
                         : (fig_point){at.x[0], at.x[1]};
}
