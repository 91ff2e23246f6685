// Pairs of triangles at rest that intersect, and the pairs of elements that the
// static check lists for them.
#include "kit/figures.h"

#include "base/require.h"
#include "surface/check.h"

enum {
    SCENES = 6,
    COLUMNS = 3,
    VERTICES_MOST = 6,
    KINDS = 4
};

/// Two triangles: the first one is vertices 0, 1 and 2.
typedef struct scene {
    const char *title;
    int vertices, second[3];
    double place[VERTICES_MOST][3];
    fig_camera camera;
} scene;

#define FIRST                                                                  \
    {0, 0, 0}, {4, 0, 0},                                                      \
    {                                                                          \
        1, 4, 0                                                                \
    }

static const scene scenes[SCENES] = {
    {"an edge through the inside",
     6,
     {3, 4, 5},
     {FIRST, {1.5, 1.25, -1.5}, {1.75, 1.25, 1.5}, {4.5, 3, 0.75}},
     {.azimuth = -18, .elevation = 24}},
    {"a vertex on the triangle",
     6,
     {3, 4, 5},
     {FIRST, {1.75, 1.25, 0}, {0.5, 2.5, 2}, {3.5, 2, 2.25}},
     {.azimuth = -18, .elevation = 24}},
    {"an edge on an edge",
     6,
     {3, 4, 5},
     {FIRST, {2.25, 1.75, -1.5}, {2.75, 2.25, 1.5}, {5, 4, 0.5}},
     {.azimuth = -18, .elevation = 24}},
    {"a common vertex, and through",
     5,
     {0, 3, 4},
     {FIRST, {2.25, 1.25, -1.5}, {1.75, 1.5, 1.75}},
     {.azimuth = -18, .elevation = 24}},
    {"a common vertex, and on it",
     5,
     {0, 3, 4},
     {FIRST, {1.75, 1.5, 0}, {3, 2.5, 2.25}},
     {.azimuth = -18, .elevation = 24}},
    {"a common edge, folded flat",
     4,
     {0, 1, 3},
     {FIRST, {4, 3, 0}},
     {.azimuth = -18, .elevation = 40}},
};

static const double panel_height = 104, title_room = 18;
static const char *const kind_key[KINDS] = {NULL, "edge_triangle",
                                            "point_triangle", "edge_edge"};

// The check --------------------------------------------------------------

/// The rows of the check, lent by the surface.
static tf_crossings check(const scene *s, tf_surface **surface)
{
    const int triangle[6] = {0, 1, 2, s->second[0], s->second[1], s->second[2]};
    tf_mesh mesh = {.axes = 3,
                    .vertices = s->vertices,
                    .triangles = 2,
                    .triangle = triangle};
    tf_crossings found = {0};
    tf_status status = tf_surface_create(&mesh, surface, NULL);
    if (status == TF_OK)
        status = tf_surface_check(*surface, s->vertices, s->place[0], NULL,
                                  &found, NULL);
    TF_REQUIRE(status == TF_OK);
    return found;
}

static tf_vector vertex(const scene *s, int v)
{
    return fig_vector_of(s->place[v]);
}

/// Where an edge passes through the plane of a triangle.
static tf_vector find_passage(const scene *s, const int v[5])
{
    tf_vector c = vertex(s, v[2]);
    tf_vector normal = fig_cross(fig_difference(vertex(s, v[3]), c),
                                 fig_difference(vertex(s, v[4]), c));
    double a = tf_vector_dot(normal, fig_difference(vertex(s, v[0]), c));
    double b = tf_vector_dot(normal, fig_difference(vertex(s, v[1]), c));
    return fig_lerp(vertex(s, v[0]), vertex(s, v[1]), a / (a - b));
}

/// Where two edges meet that are not parallel.
static tf_vector find_meeting(const scene *s, const int v[4])
{
    tf_vector a = vertex(s, v[0]), c = vertex(s, v[2]);
    tf_vector u = fig_difference(vertex(s, v[1]), a);
    tf_vector w = fig_difference(vertex(s, v[3]), c);
    tf_vector n = fig_cross(u, w);
    double part = tf_vector_dot(fig_cross(fig_difference(c, a), w), n) /
                  tf_vector_dot(n, n);
    return fig_combination(a, part, u);
}

static tf_vector find_place(const scene *s, const tf_crossing *row)
{
    switch (row->kind) {
    case TF_EDGE_THROUGH_TRIANGLE:
        return find_passage(s, row->vertex);
    case TF_EDGE_ON_EDGE:
        return find_meeting(s, row->vertex);
    default:
        return vertex(s, row->vertex[0]);
    }
}

// Drawing ----------------------------------------------------------------

static void draw_triangle(fig_scene *in, const scene *s, const int corner[3],
                          fig_role role)
{
    tf_vector at[3];
    for (int i = 0; i < 3; i++)
        at[i] = vertex(s, corner[i]);
    fig_scene_triangle(in, at, 0, (fig_paint){.role = role, .opacity = 0.6});
    for (int i = 0; i < 3; i++)
        fig_scene_tube(in, at[i], at[(i + 1) % 3], FIG_WIDTH_LINE,
                       (fig_paint){.role = role, .shade = 0.2});
}

/// The edge of a row, thick, in the color of its triangle.
static void draw_edge(fig_scene *in, const scene *s, const int edge[2])
{
    bool first = edge[0] < 3 && edge[1] < 3;
    fig_scene_tube(
        in, vertex(s, edge[0]), vertex(s, edge[1]), 2.8,
        (fig_paint){.role = first ? FIG_ROLE_TRIANGLE : FIG_ROLE_OTHER_EDGE,
                    .shade = 0.2});
}

static void draw_row(fig_scene *in, const scene *s, const tf_crossing *row)
{
    if (row->kind != TF_POINT_ON_TRIANGLE)
        draw_edge(in, s, row->vertex);
    if (row->kind == TF_EDGE_ON_EDGE)
        draw_edge(in, s, row->vertex + 2);
    fig_scene_ball(in, find_place(s, row), FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
}

static void print_counts(int number, const tf_crossings *found, FILE *numbers)
{
    int count[KINDS] = {0};
    for (size_t i = 0; i < found->count; i++)
        count[found->crossing[i].kind]++;
    for (int k = 1; k < KINDS; k++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%d", kind_key[k], number);
        fig_number(numbers, key, count[k]);
    }
}

static void draw_scene(fig_page *page, int number, FILE *numbers)
{
    static const int first[3] = {0, 1, 2};
    const scene *s = &scenes[number];
    double width = fig_page_width(page) / COLUMNS;
    int row = number / COLUMNS;
    fig_box box = {number % COLUMNS * width, row * (panel_height + title_room),
                   width, panel_height};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, s->camera);
    fig_panel_margin(panel, 9);
    fig_scene *in = fig_panel_scene(panel);
    draw_triangle(in, s, first, FIG_ROLE_TRIANGLE);
    draw_triangle(in, s, s->second, FIG_ROLE_OTHER_EDGE);
    tf_surface *surface = NULL;
    tf_crossings found = check(s, &surface);
    for (size_t i = 0; i < found.count; i++)
        draw_row(in, s, &found.crossing[i]);
    print_counts(number, &found, numbers);
    tf_surface_free(surface);
    fig_page_caption(page, box, s->title);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < SCENES; i++)
        draw_scene(page, i, numbers);
}

const fig_figure fig_static_intersections = {
    .name = "static-intersections",
    .title = "Triangles at rest that intersect, by what the check lists",
    .width = FIG_PAGE_WIDTH,
    .height = 244,
    .draw = draw,
};
