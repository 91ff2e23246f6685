// Two balls that are pressed together, and merged wherever they are near, or
// once.
#include "base/require.h"
#include "kit/figures.h"

#include "remesh/measure.h"
#include "simulate/geodesic.h"
#include "surgery/move.h"
#include "topology/facing.h"
#include "topology/merge.h"
#include "topology/merge_pass.h"
#include "topology/reconnector.h"

#include <stdlib.h>
#include <string.h>

enum {
    DIVISION = 6,
    STEPS = 10,
    WAYS = 2
};

/// Of the balls from the plane between them; how far all vertices go in a step;
/// and the part of the picture, around the axis 2.
static const double away = 1.06, way = 0.02, reach = 1.1;

/// As fractions of the usual length of an edge.
static const double limit = 0.3, contact = 0.5, wide = 0.7;

/// What became of the lower ball.
typedef struct result {
    int merges, genus;
    bool *gone; ///< of each triangle before: whether it was a wall
    bool *near; ///< of each vertex: whether it belongs to a contact
} result;

// Pressing --------------------------------------------------------------------

static tf_adaptive_surface *make_balls(void)
{
    tf_body body = {.axes = 3};
    for (int i = 0; i < 2; i++) {
        int first = body.vertices;
        tf_geodesic_add(&body, DIVISION);
        for (int v = first; v < body.vertices; v++) {
            body.position[3 * (ptrdiff_t)v] += 0.07 * i;
            body.position[3 * (ptrdiff_t)v + 1] += 0.04 * i;
            body.position[3 * (ptrdiff_t)v + 2] += i == 0 ? -away : away;
        }
    }
    TF_REQUIRE(!body.failed);
    tf_mesh mesh = tf_body_mesh(&body);
    tf_adaptive_surface *surface;
    TF_REQUIRE(tf_adaptive_create(&mesh, body.position, &surface, NULL) ==
               TF_OK);
    tf_body_free(&body);
    return surface;
}

/// Each vertex goes towards the plane, if it can.
static void press(tf_adaptive_surface *surface)
{
    for (int v = 0; v < surface->vertices; v++) {
        double to[3];
        tf_outcome outcome;
        memcpy(to, tf_vertex_coordinates(surface, v), sizeof to);
        to[2] += 2 * v < surface->vertices ? way : -way;
        TF_REQUIRE(tf_adaptive_move(surface, v, to, &outcome) == TF_OK);
    }
}

static double usual_edge(const tf_adaptive_surface *surface)
{
    double sum = 0;
    int corners = 3 * surface->triangles;
    for (int c = 0; c < corners; c++)
        sum += tf_length_of(surface, tf_vertex_at(surface, c),
                            tf_vertex_at(surface, tf_corner_after(c)));
    return sum / corners;
}

// Merging ---------------------------------------------------------------------

/// Whatever is near enough, the nearest first.
static void merge_all(tf_reconnector *reconnector)
{
    TF_REQUIRE(tf_list_facing(reconnector, reconnector->lengths.merge) ==
               TF_OK);
    const tf_facing_edges *pair = reconnector->candidate.data;
    for (int i = 0; i < reconnector->candidates; i++) {
        tf_outcome outcome;
        TF_REQUIRE(tf_adaptive_merge(reconnector->surface, pair[i].first,
                                     pair[i].second, &outcome) == TF_OK);
        tf_reconnector_count(reconnector, TF_MERGE, outcome, 0);
    }
}

/// The genus of a surface of one part.
static int genus_of(const tf_adaptive_surface *surface)
{
    int vertices = 0, triangles = 0;
    for (int v = 0; v < surface->vertices; v++)
        vertices += tf_first_corner(surface, v) != TF_NONE;
    for (int t = 0; t < surface->triangles; t++)
        triangles += tf_is_triangle(surface, t);
    return 1 - (vertices - triangles / 2) / 2;
}

/// What is near, and what has another triangle in its place than before.
static void note(const tf_reconnector *reconnector,
                 const tf_adaptive_surface *before, result *made)
{
    const int *piece = reconnector->piece.data;
    made->gone = calloc((size_t)before->triangles, sizeof *made->gone);
    made->near = calloc((size_t)before->vertices, sizeof *made->near);
    TF_REQUIRE(made->gone && made->near);
    for (int t = 0; t < before->triangles; t++)
        made->gone[t] =
            memcmp(tf_triangle(before, t), tf_triangle(reconnector->surface, t),
                   3 * sizeof(int)) != 0;
    for (int v = 0; v < before->vertices && piece; v++)
        made->near[v] = piece[v] != TF_NONE;
}

static result merge(const tf_adaptive_surface *before, bool once)
{
    tf_mesh mesh = *tf_adaptive_mesh(before);
    tf_adaptive_surface *surface;
    TF_REQUIRE(tf_adaptive_create(&mesh, tf_adaptive_positions(before),
                                  &surface, NULL) == TF_OK);
    double edge = usual_edge(before);
    tf_reconnector reconnector = {.surface = surface,
                                  .lengths = {.merge = limit * edge,
                                              .patch = contact * edge,
                                              .pinch = wide * edge}};
    if (once)
        TF_REQUIRE(tf_merge_pass(&reconnector) == TF_OK);
    else
        merge_all(&reconnector);
    result made = {.merges =
                       (int)reconnector.report.tried[TF_MERGE][TF_COMMITTED],
                   .genus = genus_of(surface)};
    note(&reconnector, before, &made);
    tf_reconnector_free(&reconnector);
    tf_adaptive_free(surface);
    return made;
}

// Drawing ---------------------------------------------------------------------

/// Whether a triangle is one of those that face the other ball.
static bool is_shown(const tf_adaptive_surface *surface, const int v[3])
{
    for (int i = 0; i < 3; i++) {
        const double *x = tf_vertex_coordinates(surface, v[i]);
        if (2 * v[i] >= surface->vertices || x[2] < -0.8 ||
            hypot(x[0], x[1]) > reach)
            return false;
    }
    return true;
}

static fig_paint paint_of(const result *made, int triangle, const int v[3])
{
    if (made->gone[triangle])
        return (fig_paint){.role = FIG_ROLE_CONTACT};
    if (made->near[v[0]] && made->near[v[1]] && made->near[v[2]])
        return (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.45};
    return (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.14};
}

/// The lower ball from above.
static void draw_contact(fig_page *page, int i,
                         const tf_adaptive_surface *surface, const result *made)
{
    static const char *const titles[WAYS] = {"wherever it is near",
                                             "once in each contact"};
    double width = fig_page_width(page) / WAYS;
    fig_box box = {width * i, 18, width, fig_page_height(page) - 18};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_fix(panel);
    fig_panel_margin(panel, 6);
    for (int t = 0; t < surface->triangles; t++) {
        const int *v = tf_triangle(surface, t);
        tf_vector corner[3];
        if (!is_shown(surface, v))
            continue;
        for (int k = 0; k < 3; k++) {
            const double *x = tf_vertex_coordinates(surface, v[k]);
            corner[k] = (tf_vector){{x[0], x[1], 0}};
        }
        fig_scene_triangle(fig_panel_scene(panel), corner, FIG_WIDTH_HAIR,
                           paint_of(made, t, v));
    }
    fig_page_title(page, box, titles[i]);
}

static void draw(fig_page *page, FILE *numbers)
{
    static tf_adaptive_surface *pressed;
    static result made[WAYS];
    if (!pressed) {
        pressed = make_balls();
        for (int i = 0; i < STEPS; i++)
            press(pressed);
        for (int i = 0; i < WAYS; i++)
            made[i] = merge(pressed, i == 1);
    }
    for (int i = 0; i < WAYS; i++)
        draw_contact(page, i, pressed, &made[i]);
    fig_number(numbers, "triangles", 0.5 * pressed->triangles);
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "limit", limit);
    fig_number(numbers, "greedy", made[0].merges);
    fig_number(numbers, "genus", made[0].genus);
    fig_number(numbers, "once", made[1].merges);
    fig_number(numbers, "once_genus", made[1].genus);
}

const fig_figure fig_merges_per_contact = {
    .name = "merges-per-contact",
    .title = "Merges where two balls are near, and one for each contact",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .draw = draw,
};
