#include "draw/query_parts.h"

#include "worlds.h"

#include <math.h>
#include <string.h>

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

fig_shown fig_shown_of(const tf_query_kind *kind, const tf_worldline given[],
                       const tf_contact *contact)
{
    fig_shown shown = {.kind = kind, .given = given, .contact = *contact};
    shown.fit = fit_vertices(kind, given, shown.vertex);
    if (fig_shown_hits(&shown)) {
        shown.toi = fig_toi(contact);
        shown.meeting = place_of(kind->vertices[0], shown.vertex,
                                 contact->barycentric[0], shown.toi);
    }
    return shown;
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

const char *fig_shown_name(const fig_shown *shown, int element, int vertex,
                           int t)
{
    static const char *const edges[2][2][2] = {
        {{"a_0", "a_0'"}, {"a_1", "a_1'"}}, {{"b_0", "b_0'"}, {"b_1", "b_1'"}}};
    static const char *const others[3][2] = {
        {"a", "a'"}, {"b", "b'"}, {"c", "c'"}};
    if (are_edges(shown->kind))
        return edges[element][vertex][t];
    if (element == 0)
        return t == 0 ? "p" : "p'";
    return others[vertex][t];
}

const tf_worldline *fig_shown_element(const fig_shown *shown, int element)
{
    return shown->vertex + (element == 0 ? 0 : shown->kind->vertices[0]);
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
