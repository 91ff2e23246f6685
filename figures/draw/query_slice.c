// The elements of a query in space at one time.
#include "draw/query_parts.h"
#include "kit/worlds.h"

#include <string.h>

/// Of the balls at the ends of an edge, in points.
static const double end_diameter = 4;

/// An element at rest at t = 0 or t = 1, in outline.
static void add_outline(fig_scene *scene, const fig_shown *shown, int element,
                        int t)
{
    const tf_worldline *vertex = fig_shown_element(shown, element);
    int count = shown->kind->vertices[element];
    fig_paint paint = {.role = t == 0 ? FIG_ROLE_START : FIG_ROLE_END};
    for (int i = 0; i < count; i++)
        fig_scene_tube(scene, fig_vector_of(vertex[i].at[t].x),
                       fig_vector_of(vertex[(i + 1) % count].at[t].x),
                       FIG_WIDTH_THIN, paint);
}

/// The whole step, faintly: the same at all times.
static void add_step(fig_scene *scene, const fig_shown *shown)
{
    const fig_paint faint = {FIG_ROLE_NEUTRAL, 0.6, 0};
    for (int element = 0; element < 2; element++) {
        const tf_worldline *vertex = fig_shown_element(shown, element);
        for (int i = 0; i < shown->kind->vertices[element]; i++)
            fig_scene_tube(scene, fig_vector_of(vertex[i].at[0].x),
                           fig_vector_of(vertex[i].at[1].x), FIG_WIDTH_HAIR,
                           faint);
        add_outline(scene, shown, element, 0);
        add_outline(scene, shown, element, 1);
    }
}

/// The ends of an edge; one of no length shows by them alone.
static void add_ends(fig_scene *scene, const fig_shown *shown, int element,
                     double t)
{
    const tf_worldline *end = fig_shown_element(shown, element);
    for (int i = 0; i < 2; i++)
        fig_scene_ball(
            scene, fig_worldline_place(&end[i], shown->kind->axes, t),
            end_diameter, (fig_paint){.role = fig_shown_role(shown, element)});
}

static void add_element(fig_scene *scene, const fig_shown *shown, int element,
                        double t)
{
    int vertices = shown->kind->vertices[element];
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(vertices, fig_shown_element(shown, element), sweep);
    fig_paint paint = {fig_shown_role(shown, element), vertices == 3 ? 0.55 : 1,
                       0};
    double width = vertices == 3 ? FIG_WIDTH_LINE : FIG_WIDTH_TUBE;
    for (int i = 0; i < vertices; i++) {
        fig_slice slice = fig_slice_of(&sweep[i], shown->kind->axes, t);
        fig_add_polygon(scene, slice.count, slice.corner, width, paint);
    }
    if (vertices == 2)
        add_ends(scene, shown, element, t);
}

/// Name the vertices where they are at t = 0 or t = 1, or at the one time of a
/// picture.
static void label_vertices(fig_panel *panel, const fig_shown *shown, double t)
{
    bool named = t == 0 || t == 1 || shown->answered->still;
    for (int element = 0; element < 2 && named; element++) {
        const tf_worldline *vertex = fig_shown_element(shown, element);
        for (int i = 0; i < shown->kind->vertices[element]; i++) {
            char text[FIG_NAME_TEXT];
            fig_shown_name(shown, element, i, t == 1, text);
            fig_label label = {.text = text,
                               .role = fig_shown_role(shown, element),
                               .size = FIG_LETTERS_SMALL,
                               .gap = 3};
            fig_panel_label(
                panel, fig_worldline_place(&vertex[i], shown->kind->axes, t),
                label);
        }
    }
}

static void add_contact(fig_panel *panel, const fig_shown *shown)
{
    fig_scene_ball(fig_panel_scene(panel), shown->meeting, FIG_WIDTH_BALL + 1.5,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
    fig_add_normal(panel, shown, shown->meeting);
}

void fig_show_slice(fig_panel *panel, const fig_shown *shown, double t,
                    bool marked)
{
    fig_scene *scene = fig_panel_scene(panel);
    fig_panel_look(panel, fig_shown_camera);
    add_step(scene, shown);
    for (int element = 0; element < 2; element++)
        add_element(scene, shown, element, t);
    if (marked)
        add_contact(panel, shown);
    label_vertices(panel, shown, t);
}
