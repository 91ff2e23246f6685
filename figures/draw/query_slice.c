// The elements of a query in space at one time.
#include "draw/query_parts.h"
#include "worlds.h"

#include "stage/vector.h"

#include <stdio.h>
#include <string.h>

/// How far a contact's normal reaches, in sides of the box.
static const double normal_length = 0.3;

/// Of the balls at the ends of an edge, in points.
static const double end_diameter = 4;

/// An element at rest at t = 0 or t = 1, in outline.
static void add_outline(tf_scene *scene, const tf_shown *shown, int element,
                        int t)
{
    const tf_worldline *vertex = tf_shown_element(shown, element);
    int count = shown->kind->vertices[element];
    tf_paint paint = {.role = t == 0 ? TF_ROLE_START : TF_ROLE_END};
    for (int i = 0; i < count; i++)
        tf_scene_tube(scene, vertex[i].at[t].x, vertex[(i + 1) % count].at[t].x,
                      TF_WIDTH_THIN, paint);
}

/// The whole step, faintly: the same at all times.
static void add_step(tf_scene *scene, const tf_shown *shown)
{
    const tf_paint faint = {TF_ROLE_NEUTRAL, 0.6, 0};
    for (int element = 0; element < 2; element++) {
        const tf_worldline *vertex = tf_shown_element(shown, element);
        for (int i = 0; i < shown->kind->vertices[element]; i++)
            tf_scene_tube(scene, vertex[i].at[0].x, vertex[i].at[1].x,
                          TF_WIDTH_HAIR, faint);
        add_outline(scene, shown, element, 0);
        add_outline(scene, shown, element, 1);
    }
}

/// The ends of an edge; one of no length shows by them alone.
static void add_ends(tf_scene *scene, const tf_shown *shown, int element,
                     double t)
{
    for (int i = 0; i < 2; i++) {
        double place[3];
        tf_worldline_place(&tf_shown_element(shown, element)[i],
                           shown->kind->axes, t, place);
        tf_scene_ball(scene, place, end_diameter,
                      (tf_paint){.role = tf_shown_role(shown, element)});
    }
}

static void add_element(tf_scene *scene, const tf_shown *shown, int element,
                        double t)
{
    int vertices = shown->kind->vertices[element];
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(vertices, tf_shown_element(shown, element), sweep);
    tf_paint paint = {tf_shown_role(shown, element), vertices == 3 ? 0.55 : 1,
                      0};
    double width = vertices == 3 ? TF_WIDTH_LINE : TF_WIDTH_TUBE;
    for (int i = 0; i < vertices; i++) {
        tf_slice slice = tf_slice_of(&sweep[i], shown->kind->axes, t);
        tf_add_polygon(scene, slice.count, (const double(*)[3])slice.corner,
                       width, paint);
    }
    if (vertices == 2)
        add_ends(scene, shown, element, t);
}

/// Name the vertices where they are at t = 0 or t = 1, if it is that time.
static void label_vertices(tf_panel *panel, const tf_shown *shown, double t)
{
    for (int element = 0; element < 2 && (t == 0 || t == 1); element++)
        for (int i = 0; i < shown->kind->vertices[element]; i++) {
            char text[16];
            snprintf(text, sizeof text, "$%s$",
                     tf_shown_name(shown, element, i, (int)t));
            tf_label label = {.text = text,
                              .role = tf_shown_role(shown, element),
                              .size = TF_LETTERS_SMALL,
                              .gap = 3};
            tf_panel_label(
                panel, tf_shown_element(shown, element)[i].at[(int)t].x, label);
        }
}

static void add_contact(tf_scene *scene, const tf_shown *shown)
{
    const tf_paint paint = {.role = TF_ROLE_CONTACT};
    tf_scene_ball(scene, shown->meeting, TF_WIDTH_BALL + 1.5, paint);
    double tip[3];
    tf_add(shown->meeting, normal_length, shown->contact.normal, tip);
    if (shown->fit.alike &&
        tf_dot(shown->contact.normal, shown->contact.normal) > 0)
        tf_scene_arrow(scene, shown->meeting, tip, TF_WIDTH_LINE, paint);
}

void tf_show_slice(tf_panel *panel, const tf_shown *shown, double t,
                   bool marked)
{
    tf_scene *scene = tf_panel_scene(panel);
    tf_panel_look(panel, tf_shown_camera);
    add_step(scene, shown);
    for (int element = 0; element < 2; element++)
        add_element(scene, shown, element, t);
    if (marked)
        add_contact(scene, shown);
    label_vertices(panel, shown, t);
}
