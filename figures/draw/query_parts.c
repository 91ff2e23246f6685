#include "draw/query_parts.h"

#include "kit/worlds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/// How far a contact's normal reaches, in sides of the box.
static const double normal_length = 0.3;

const fig_camera fig_shown_camera = {.azimuth = 28, .elevation = 24};

// The box ----------------------------------------------------------------

static int vertices_of(const tf_query_kind *kind)
{
    return kind->vertices[0] + kind->vertices[1];
}

/// Move the events of the query to the box.
static fig_fit fit_vertices(const tf_query_kind *kind,
                            const tf_worldline given[], tf_worldline fitted[])
{
    tf_vector point[2 * FIG_QUERY_VERTICES];
    int count = 2 * vertices_of(kind);
    for (int i = 0; i < count; i++)
        point[i] = fig_vector_of(given[i / 2].at[i % 2].x);
    fig_fit fit = fig_fit_points(kind->axes, count, point);
    for (int i = 0; i < count; i++) {
        tf_event *event = &fitted[i / 2].at[i % 2];
        memcpy(event->x, point[i].x, sizeof event->x);
        event->t = i % 2;
    }
    return fit;
}

/// The place in an element's sweep at the time t of the point that has these
/// weights of its vertices: those of the last vertices are at t = 1.
static tf_vector place_of(int vertices, const tf_worldline element[],
                          const double weight[], double t)
{
    double late_left = t;
    tf_vector place = {{0}};
    for (int i = vertices - 1; i >= 0; i--) {
        double late = fmin(weight[i], late_left);
        late_left -= late;
        place = fig_combination(place, weight[i] - late,
                                fig_vector_of(element[i].at[0].x));
        place = fig_combination(place, late, fig_vector_of(element[i].at[1].x));
    }
    return place;
}

fig_shown fig_shown_of(const fig_answered *answered)
{
    const tf_query_kind *kind = answered->kind;
    fig_shown shown = {.answered = answered,
                       .kind = kind,
                       .given = answered->vertex,
                       .contact = answered->contact};
    shown.fit = fit_vertices(kind, shown.given, shown.vertex);
    if (fig_shown_hits(&shown)) {
        shown.toi = fig_toi(&shown.contact);
        shown.meeting = place_of(kind->vertices[0], shown.vertex,
                                 shown.contact.barycentric[0], shown.toi);
    }
    return shown;
}

tf_vector fig_shown_meeting(const fig_shown *shown)
{
    return place_of(shown->kind->vertices[0], shown->given,
                    shown->contact.barycentric[0], shown->toi);
}

bool fig_shown_hits(const fig_shown *shown)
{
    return shown->contact.verdict == TF_HIT;
}

// Roles and names --------------------------------------------------------

/// Kinds differ in the numbers of vertices.
static bool are_edges(const tf_query_kind *kind)
{
    return kind->vertices[0] == 2;
}

fig_role fig_shown_role(const fig_shown *shown, int element)
{
    if (are_edges(shown->kind))
        return element == 0 ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE;
    if (element == 0)
        return FIG_ROLE_POINT;
    return shown->kind->vertices[1] == 2 ? FIG_ROLE_EDGE : FIG_ROLE_TRIANGLE;
}

void fig_shown_name(const fig_shown *shown, int element, int vertex, int t,
                    char text[FIG_NAME_TEXT])
{
    static const char *const edges[] = {"a_0", "a_1", "b_0", "b_1"};
    static const char *const others[] = {"p", "a", "b", "c"};
    int row = element == 0 ? vertex : shown->kind->vertices[0] + vertex;
    const char *name = shown->answered->names   ? shown->answered->names[row]
                       : are_edges(shown->kind) ? edges[row]
                                                : others[row];
    snprintf(text, FIG_NAME_TEXT, "$%s%s$", name, t == 0 ? "" : "'");
}

const tf_worldline *fig_shown_element(const fig_shown *shown, int element)
{
    return shown->vertex + (element == 0 ? 0 : shown->kind->vertices[0]);
}

// The normal -------------------------------------------------------------

void fig_add_normal(fig_panel *panel, const fig_shown *shown, tf_vector from)
{
    const fig_paint paint = {.role = FIG_ROLE_CONTACT};
    tf_vector normal = fig_vector_of(shown->contact.normal);
    if (!shown->fit.alike || fig_length(normal) == 0)
        return;
    tf_vector tip = fig_combination(from, normal_length, normal);
    fig_scene_arrow(fig_panel_scene(panel), from, tip, FIG_WIDTH_LINE, paint);
    if (shown->answered->coordinates)
        fig_panel_label(panel, tip,
                        (fig_label){.text = "$\\b{n}$",
                                    .role = FIG_ROLE_CONTACT,
                                    .size = FIG_LETTERS_SMALL,
                                    .gap = 3});
}

// Polygons ---------------------------------------------------------------

void fig_add_polygon(fig_scene *scene, int count, const tf_vector corner[],
                     double width, fig_paint paint)
{
    if (count == 1)
        fig_scene_ball(scene, corner[0], FIG_WIDTH_BALL, paint);
    for (int i = 2; i < count; i++)
        fig_scene_triangle(scene,
                           (tf_vector[]){corner[0], corner[i - 1], corner[i]},
                           0, paint);
    int sides = count <= 2 ? count - 1 : count;
    for (int i = 0; i < sides; i++)
        fig_scene_tube(scene, corner[i], corner[(i + 1) % count], width,
                       (fig_paint){paint.role, 1, paint.shade});
}
