// A query of the plane in space-time.
#include "draw/query_parts.h"
#include "worlds.h"

#include "stage/vector.h"

#include <stdio.h>
#include <string.h>

/// Half the side of the planes at t = 0 and t = 1.
static const double half = 0.6;

static void label_plane(tf_panel *panel, double t, const char *text,
                        tf_role role)
{
    const double corner[3] = {half, half, t};
    tf_panel_label(panel, corner,
                   (tf_label){.text = text,
                              .role = role,
                              .size = TF_LETTERS_SMALL,
                              .side = TF_SIDE_NE,
                              .gap = 2});
}

static void add_plane(tf_scene *scene, double t, tf_role role)
{
    const double origin[3] = {-half, -half, t};
    const double u[3] = {2 * half, 0, 0}, v[3] = {0, 2 * half, 0};
    tf_scene_grid(scene, origin, u, v, 4, 4, role);
}

static void add_sweep(tf_scene *scene, const tf_shown *shown, int element)
{
    int vertices = shown->kind->vertices[element];
    tf_role role = tf_shown_role(shown, element);
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(vertices, tf_shown_element(shown, element), sweep);
    for (int i = 0; i < vertices; i++) {
        double corner[TF_EVENTS][3];
        tf_world_of_simplex(&sweep[i], corner);
        if (sweep[i].count == 2)
            tf_scene_worldline(scene, corner[0], corner[1], TF_WIDTH_TUBE,
                               (tf_paint){.role = role});
        else
            tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                              (tf_paint){role, 0.45, i == 0 ? 0 : -0.25});
    }
}

static void add_events(tf_panel *panel, const tf_shown *shown, int element)
{
    tf_role role = tf_shown_role(shown, element);
    for (int i = 0; i < 2 * shown->kind->vertices[element]; i++) {
        double at[3];
        tf_world_of_event(&tf_shown_element(shown, element)[i / 2].at[i % 2],
                          at);
        tf_scene_ball(tf_panel_scene(panel), at, TF_WIDTH_BALL,
                      (tf_paint){.role = role});
        char text[16];
        snprintf(text, sizeof text, "$%s$",
                 tf_shown_name(shown, element, i / 2, i % 2));
        tf_panel_label(panel, at, (tf_label){.text = text, .role = role});
    }
}

/// What there is of an element at the time t.
static void add_present(tf_scene *scene, const tf_shown *shown, int element,
                        double t, tf_paint paint)
{
    int vertices = shown->kind->vertices[element];
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(vertices, tf_shown_element(shown, element), sweep);
    for (int i = 0; i < vertices; i++) {
        tf_slice slice = tf_slice_of(&sweep[i], shown->kind->axes, t);
        for (int j = 0; j < slice.count; j++)
            slice.corner[j][2] = t;
        tf_add_polygon(scene, slice.count, (const double(*)[3])slice.corner,
                       TF_WIDTH_TUBE, paint);
    }
}

void tf_show_spacetime(tf_panel *panel, const tf_shown *shown, double t)
{
    tf_scene *scene = tf_panel_scene(panel);
    tf_panel_look(panel, tf_shown_camera);
    add_plane(scene, 0, TF_ROLE_START);
    add_plane(scene, 1, TF_ROLE_END);
    label_plane(panel, 0, "$t = 0$", TF_ROLE_START);
    label_plane(panel, 1, "$t = 1$", TF_ROLE_END);
    for (int element = 0; element < 2; element++) {
        add_sweep(scene, shown, element);
        add_events(panel, shown, element);
    }
    if (t >= 0)
        add_plane(scene, t, TF_ROLE_NEUTRAL);
    for (int element = 0; element < 2 && t >= 0; element++)
        add_present(scene, shown, element, t,
                    (tf_paint){tf_shown_role(shown, element), 1, 0.35});
    if (!tf_shown_hits(shown))
        return;
    add_present(scene, shown, 1, shown->toi,
                (tf_paint){.role = TF_ROLE_CONTACT});
    const double meeting[3] = {shown->meeting[0], shown->meeting[1],
                               shown->toi};
    tf_scene_ball(scene, meeting, TF_WIDTH_MARK,
                  (tf_paint){.role = TF_ROLE_CONTACT});
}
