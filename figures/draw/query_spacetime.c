// A query of the plane in space-time.
#include "draw/query_parts.h"
#include "kit/worlds.h"

#include <string.h>

/// Half the side of the planes at t = 0 and t = 1.
static const double half = 0.6;

static void label_plane(fig_panel *panel, double t, const char *text,
                        fig_role role)
{
    fig_panel_label(panel, (tf_vector){{half, half, t}},
                    (fig_label){.text = text,
                                .role = role,
                                .size = FIG_LETTERS_SMALL,
                                .side = FIG_SIDE_NE,
                                .gap = 2});
}

static void add_plane(fig_scene *scene, double t, fig_role role)
{
    fig_scene_grid(scene, (tf_vector){{-half, -half, t}},
                   (tf_vector){{2 * half, 0, 0}}, (tf_vector){{0, 2 * half, 0}},
                   4, 4, role);
}

static void add_sweep(fig_scene *scene, const fig_shown *shown, int element)
{
    int vertices = shown->kind->vertices[element];
    fig_role role = fig_shown_role(shown, element);
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(vertices, fig_shown_element(shown, element), sweep);
    for (int i = 0; i < vertices; i++) {
        tf_vector corner[TF_EVENTS];
        fig_world_of_simplex(&sweep[i], corner);
        if (sweep[i].count == 2)
            fig_scene_worldline(scene, corner[0], corner[1], FIG_WIDTH_TUBE,
                                (fig_paint){.role = role});
        else
            fig_scene_triangle(scene, corner, FIG_WIDTH_THIN,
                               (fig_paint){role, 0.45, i == 0 ? 0 : -0.25});
    }
}

static void add_events(fig_panel *panel, const fig_shown *shown, int element)
{
    fig_role role = fig_shown_role(shown, element);
    for (int i = 0; i < 2 * shown->kind->vertices[element]; i++) {
        tf_vector at = fig_world_of_event(
            &fig_shown_element(shown, element)[i / 2].at[i % 2]);
        fig_scene_ball(fig_panel_scene(panel), at, FIG_WIDTH_BALL,
                       (fig_paint){.role = role});
        char text[FIG_NAME_TEXT];
        fig_shown_name(shown, element, i / 2, i % 2, text);
        fig_panel_label(panel, at, (fig_label){.text = text, .role = role});
    }
}

/// What there is of an element at the time t.
static void add_present(fig_scene *scene, const fig_shown *shown, int element,
                        double t, fig_paint paint)
{
    int vertices = shown->kind->vertices[element];
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(vertices, fig_shown_element(shown, element), sweep);
    for (int i = 0; i < vertices; i++) {
        fig_slice slice = fig_slice_of(&sweep[i], shown->kind->axes, t);
        for (int j = 0; j < slice.count; j++)
            slice.corner[j].x[2] = t;
        fig_add_polygon(scene, slice.count, slice.corner, FIG_WIDTH_TUBE,
                        paint);
    }
}

void fig_show_spacetime(fig_panel *panel, const fig_shown *shown, double t)
{
    fig_scene *scene = fig_panel_scene(panel);
    fig_panel_look(panel, fig_shown_camera);
    add_plane(scene, 0, FIG_ROLE_START);
    add_plane(scene, 1, FIG_ROLE_END);
    label_plane(panel, 0, "$t = 0$", FIG_ROLE_START);
    label_plane(panel, 1, "$t = 1$", FIG_ROLE_END);
    for (int element = 0; element < 2; element++) {
        add_sweep(scene, shown, element);
        add_events(panel, shown, element);
    }
    if (t >= 0)
        add_plane(scene, t, FIG_ROLE_NEUTRAL);
    for (int element = 0; element < 2 && t >= 0; element++)
        add_present(scene, shown, element, t,
                    (fig_paint){fig_shown_role(shown, element), 1, 0.35});
    if (!fig_shown_hits(shown))
        return;
    add_present(scene, shown, 1, shown->toi,
                (fig_paint){.role = FIG_ROLE_CONTACT});
    tf_vector meeting = shown->meeting;
    meeting.x[2] = shown->toi;
    fig_scene_ball(scene, meeting, FIG_WIDTH_MARK,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
    if (shown->answered->coordinates)
        fig_add_normal(panel, shown, meeting);
}
