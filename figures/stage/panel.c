#include "contract.h"
#include "stage/list.h"
#include "stage/page_parts.h"
#include "stage/vector.h"

#include <float.h>
#include <stdlib.h>

enum {
    TURNS = 24
}; ///< azimuths to which a panel that may be turned is fitted

/// A panel to draw on when there is no memory for another one is the last one
/// that there is; without any, there is nothing to go on with.
static tf_panel *add_panel(tf_page *page)
{
    tf_panel *panel = calloc(1, sizeof *panel);
    if (panel == NULL || !tf_list_room(&page->panels, page->panel_count, 1,
                                       &page->panel_room, sizeof(tf_panel *))) {
        free(panel);
        tf_page_note(page, TF_STAGE_NO_MEMORY);
        TF_REQUIRE(page->panel_count > 0);
        return page->panels[page->panel_count - 1];
    }
    page->panels[page->panel_count++] = panel;
    return panel;
}

tf_panel *tf_page_panel(tf_page *page, tf_box box)
{
    TF_REQUIRE(box.width > 0 && box.height > 0);
    tf_panel *panel = add_panel(page);
    panel->page = page;
    panel->box = box;
    panel->margin = TF_FIT_MARGIN;
    tf_page_add_mark(page, (tf_mark){.kind = TF_MARK_PANEL, .panel = panel});
    return panel;
}

tf_scene *tf_panel_scene(tf_panel *panel)
{
    return &panel->scene;
}

void tf_panel_look(tf_panel *panel, tf_camera camera)
{
    panel->camera = camera;
}

void tf_panel_margin(tf_panel *panel, double margin)
{
    panel->margin = margin;
}

void tf_panel_fix(tf_panel *panel)
{
    panel->fixed = true;
}

/// Where points are as the scene turns once around the up axis through the
/// middle of their bounds.  NULL if there is no memory.
static double (*turned_points(const tf_scene *scene))[3]
{
    int count = scene->reached_count;
    double(*all)[3] = malloc((size_t)count * TURNS * sizeof *all);
    double lo[2] = {DBL_MAX, DBL_MAX}, hi[2] = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], scene->reached[i][k]);
            hi[k] = fmax(hi[k], scene->reached[i][k]);
        }
    for (int i = 0; all != NULL && i < count * TURNS; i++) {
        const double *at = scene->reached[i / TURNS];
        double x = at[0] - (lo[0] + hi[0]) / 2, y = at[1] - (lo[1] + hi[1]) / 2;
        double turn = 6.283185307179586 * (i % TURNS) / TURNS;
        all[i][0] = (lo[0] + hi[0]) / 2 + x * cos(turn) - y * sin(turn);
        all[i][1] = (lo[1] + hi[1]) / 2 + x * sin(turn) + y * cos(turn);
        all[i][2] = at[2];
    }
    return all;
}

/// Fit a camera that turns: as far off for every azimuth.
static tf_camera fit_turning(const tf_panel *panel, const tf_camera *camera)
{
    double(*all)[3] = turned_points(&panel->scene);
    if (all == NULL) {
        tf_page_note(panel->page, TF_STAGE_NO_MEMORY);
        return *camera;
    }
    tf_camera fitted = tf_camera_fit(camera, TURNS * panel->scene.reached_count,
                                     (const double(*)[3])all, panel->box.width,
                                     panel->box.height, panel->margin);
    free(all);
    return fitted;
}

tf_view tf_panel_view(const tf_panel *panel)
{
    const tf_page_options *options = &panel->page->options;
    tf_camera camera = panel->camera;
    bool turning = options->turned && !panel->fixed;
    if (turning) {
        camera.azimuth = options->azimuth;
        camera.elevation = options->elevation;
    }
    bool fit = camera.height == 0 && panel->scene.reached_count > 0;
    if (fit && turning)
        camera = fit_turning(panel, &camera);
    else if (fit)
        camera =
            tf_camera_fit(&camera, panel->scene.reached_count,
                          (const double(*)[3])panel->scene.reached,
                          panel->box.width, panel->box.height, panel->margin);
    if (camera.height == 0)
        camera.height = 1;
    return tf_view_of(&camera, panel->box);
}

void tf_panel_project(const tf_panel *panel, const double world[3],
                      double page[2])
{
    tf_view view = tf_panel_view(panel);
    tf_view_project(&view, world, page);
}

void tf_page_point(const tf_panel *panel, const double at[3], double point[2])
{
    if (panel != NULL) {
        tf_panel_project(panel, at, point);
        return;
    }
    point[0] = at[0];
    point[1] = at[1];
}

void tf_panel_axes(tf_panel *panel, const double origin[3],
                   const double length[3], const char *const name[3])
{
    const tf_paint paint = {.role = TF_ROLE_NEUTRAL};
    for (int k = 0; k < 3; k++) {
        if (length[k] == 0)
            continue;
        double tip[3];
        tf_add(origin, 0, origin, tip);
        tip[k] += length[k];
        tf_scene_arrow(&panel->scene, origin, tip, TF_WIDTH_LINE, paint);
        if (name[k] != NULL)
            tf_panel_label(panel, tip,
                           (tf_label){.text = name[k],
                                      .role = TF_ROLE_INK,
                                      .side = k == 2 ? TF_SIDE_N : TF_SIDE_ANY,
                                      .gap = 3});
    }
}
