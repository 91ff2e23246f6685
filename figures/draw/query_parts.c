#include "draw/query_parts.h"

#include "stage/vector.h"

#include <math.h>
#include <string.h>

const tf_camera tf_shown_camera = {.azimuth = 28, .elevation = 24};

// The box ----------------------------------------------------------------

static int vertices_of(const tf_query_kind *kind)
{
    return kind->vertices[0] + kind->vertices[1];
}

/// Move the events of the question to the box.
static tf_fit fit_vertices(const tf_query_kind *kind,
                           const tf_worldline asked[], tf_worldline fitted[])
{
    double point[2 * TF_QUESTION_VERTICES][3] = {0};
    int count = 2 * vertices_of(kind);
    for (int i = 0; i < count; i++)
        memcpy(point[i], asked[i / 2].at[i % 2].x,
               (size_t)kind->axes * sizeof point[i][0]);
    tf_fit fit = tf_fit_points(kind->axes, count, point);
    for (int i = 0; i < count; i++) {
        tf_event *event = &fitted[i / 2].at[i % 2];
        memcpy(event->x, point[i], sizeof point[i]);
        event->t = i % 2;
    }
    return fit;
}

/// The place in an element's sweep at the time t of the point that has these
/// weights of its vertices: those of the last vertices are at t = 1.
static void find_place(int vertices, const tf_worldline element[],
                       const double weight[], double t, double place[3])
{
    double late_left = t;
    memset(place, 0, 3 * sizeof *place);
    for (int i = vertices - 1; i >= 0; i--) {
        double late = fmin(weight[i], late_left);
        late_left -= late;
        tf_add(place, weight[i] - late, element[i].at[0].x, place);
        tf_add(place, late, element[i].at[1].x, place);
    }
}

tf_shown tf_shown_of(const tf_query_kind *kind, const tf_worldline asked[],
                     const tf_contact *contact)
{
    tf_shown shown = {.kind = kind, .asked = asked, .contact = *contact};
    shown.fit = fit_vertices(kind, asked, shown.vertex);
    if (tf_shown_hits(&shown)) {
        shown.toi = contact->toi_lo / 2 + contact->toi_hi / 2;
        find_place(kind->vertices[0], shown.vertex, contact->weight[0],
                   shown.toi, shown.meeting);
    }
    return shown;
}

bool tf_shown_hits(const tf_shown *shown)
{
    return shown->contact.verdict == TF_HIT;
}

// Roles and names --------------------------------------------------------

/// Kinds differ in the numbers of vertices.
static bool are_edges(const tf_query_kind *kind)
{
    return kind->vertices[0] == 2;
}

tf_role tf_shown_role(const tf_shown *shown, int element)
{
    if (are_edges(shown->kind))
        return element == 0 ? TF_ROLE_EDGE : TF_ROLE_OTHER_EDGE;
    if (element == 0)
        return TF_ROLE_POINT;
    return shown->kind->vertices[1] == 2 ? TF_ROLE_EDGE : TF_ROLE_TRIANGLE;
}

const char *tf_shown_name(const tf_shown *shown, int element, int vertex, int t)
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

const tf_worldline *tf_shown_element(const tf_shown *shown, int element)
{
    return shown->vertex + (element == 0 ? 0 : shown->kind->vertices[0]);
}

// Polygons ---------------------------------------------------------------

void tf_add_polygon(tf_scene *scene, int count, const double corner[][3],
                    double width, tf_paint paint)
{
    if (count == 1)
        tf_scene_ball(scene, corner[0], TF_WIDTH_BALL, paint);
    for (int i = 2; i < count; i++) {
        double face[3][3];
        memcpy(face[0], corner[0], sizeof face[0]);
        memcpy(face[1], corner[i - 1], 2 * sizeof face[1]);
        tf_scene_triangle(scene, (const double(*)[3])face, 0, paint);
    }
    int sides = count <= 2 ? count - 1 : count;
    for (int i = 0; i < sides; i++)
        tf_scene_tube(scene, corner[i], corner[(i + 1) % count], width,
                      (tf_paint){paint.role, 1, paint.shade});
}
