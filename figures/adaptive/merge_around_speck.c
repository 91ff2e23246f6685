// Two boxes that merge, and a speck between them, which is inside then.
#include "base/require.h"
#include "experiments/leave_out.h"
#include "kit/figures.h"
#include "kit/patches.h"

#include "surgery/adaptive_surface.h"
#include "topology/merge.h"
#include "topology/winding.h"

enum {
    BOX = 8,         ///< corners of a box
    SPECK = 2 * BOX, ///< the first vertex of the speck
    PLACES = SPECK + 4,
    TRIANGLES = 28
};

static const int triangles[TRIANGLES][3] = {
    {0, 2, 1},    {0, 3, 2},    {4, 5, 6},    {4, 6, 7},    {0, 1, 5},
    {0, 5, 4},    {1, 2, 6},    {1, 6, 5},    {2, 3, 7},    {2, 7, 6},
    {3, 0, 4},    {3, 4, 7},    {8, 10, 9},   {8, 11, 10},  {12, 13, 14},
    {12, 14, 15}, {8, 9, 13},   {8, 13, 12},  {9, 10, 14},  {9, 14, 13},
    {10, 11, 15}, {10, 15, 14}, {11, 8, 12},  {11, 12, 15}, {16, 18, 17},
    {16, 17, 19}, {17, 18, 19}, {18, 16, 19},
};

static const double heights[] = {-1.5, -0.4, 0.4, 1.5},
                    speck_place[] = {0.1, -0.25, -0.12}, speck_size = 0.24;

static void make_places(double place[PLACES][3])
{
    for (int v = 0; v < SPECK; v++) {
        int corner = v % 4;
        place[v][0] = corner == 1 || corner == 2 ? 0.8 : -0.8;
        place[v][1] = corner >= 2 ? 0.8 : -0.8;
        place[v][2] = heights[v / 4];
    }
    for (int i = 0; i < 12; i++)
        place[SPECK + i / 3][i % 3] =
            speck_place[i % 3] + (i / 3 == i % 3 + 1 ? speck_size : 0);
}

static tf_adaptive_surface *make_surface(void)
{
    double place[PLACES][3];
    make_places(place);
    const tf_mesh mesh = {.axes = 3,
                          .vertices = PLACES,
                          .triangles = TRIANGLES,
                          .triangle = triangles[0]};
    tf_adaptive_surface *surface;
    TF_REQUIRE(tf_adaptive_create(&mesh, place[0], &surface, NULL) == TF_OK);
    return surface;
}

/// Merges the faces between the boxes, leaving out tests.
static tf_outcome merge(tf_adaptive_surface *surface, unsigned left_out)
{
    static const int low[] = {4, 6}, high[] = {8, 10};
    tf_outcome outcome;
    leave_out(left_out);
    TF_REQUIRE(tf_adaptive_merge(surface, low, high, &outcome) == TF_OK);
    leave_out(0);
    return outcome;
}

static bool is_of_speck(const int triangle[3])
{
    return triangle[0] >= SPECK;
}

/// How often all but the speck goes around the speck.
static int winding_of(const tf_adaptive_surface *surface)
{
    int sum = 0;
    for (int t = 0; t < surface->triangles; t++) {
        const int *v = tf_triangle(surface, t);
        if (*v == TF_NONE || is_of_speck(v))
            continue;
        tf_facet facet = tf_facet_of(surface, v);
        sum += tf_winding_part(facet.corner,
                               tf_vertex_coordinates(surface, SPECK));
    }
    return sum;
}

/// Whether a triangle is one of the tube: it has corners of both boxes.
static bool is_of_tube(const int v[3])
{
    return (v[0] < BOX) != (v[1] < BOX) || (v[0] < BOX) != (v[2] < BOX);
}

static void draw_surface(fig_page *page, fig_box box,
                         const tf_adaptive_surface *surface)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 24, .elevation = 16});
    fig_panel_margin(panel, 8);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    for (int v = 0; v < PLACES; v++)
        at[v] = fig_vector_of(tf_vertex_coordinates(surface, v));
    for (int t = 0; t < surface->triangles; t++) {
        const int *v = tf_triangle(surface, t);
        if (*v == TF_NONE)
            continue;
        fig_paint paint = {.role = FIG_ROLE_TRIANGLE, .opacity = 0.35};
        if (is_of_speck(v))
            paint = (fig_paint){.role = FIG_ROLE_CONTACT};
        else if (is_of_tube(v))
            paint = (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.35};
        const int corner[1][3] = {{v[0], v[1], v[2]}};
        fig_patch_triangles(scene, at, 1, corner, paint);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / 2, height = fig_page_height(page);
    tf_adaptive_surface *surface = make_surface();
    draw_surface(page, (fig_box){0, 0, width, height}, surface);
    fig_number(numbers, "winding_before", winding_of(surface));
    fig_number(numbers, "refused", merge(surface, 0) == TF_PASSED_VERTEX);
    fig_number(numbers, "done",
               merge(surface, 1U << TF_PASSED_VERTEX) == TF_COMMITTED);
    draw_surface(page, (fig_box){width, 0, width, height}, surface);
    fig_number(numbers, "winding_after", winding_of(surface));
    tf_adaptive_free(surface);
}

const fig_figure fig_merge_around_speck = {
    .name = "merge-around-speck",
    .title = "Two boxes that merge, and a speck between them",
    .width = FIG_PAGE_WIDTH,
    .height = 220,
    .draw = draw,
};
