// A merge: two quadrilaterals that face each other, the tube between them, and
// the ball that both together bound.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/patches.h"

#include "surgery/adaptive_surface.h"
#include "topology/merge.h"

enum {
    CORNERS = 8,
    WALLS = 4,
    TUBE = 8,
    STATES = 3
};

static const double places[CORNERS][3] = {
    {-1, -0.7, 0},     {0.9, -0.8, 0.12}, {1.05, 0.7, 0},   {-0.85, 0.8, 0.15},
    {-0.9, -0.8, 1.2}, {1, -0.7, 1.05},   {0.9, 0.8, 1.25}, {-1, 0.7, 1.1}};
static const int walls[WALLS][3] = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};

/// Merges two surfaces that are only the walls; returns how many triangles are
/// there then.
static int merge(int tube[TUBE][3])
{
    const tf_mesh mesh = {.axes = 3,
                          .vertices = CORNERS,
                          .triangles = WALLS,
                          .triangle = walls[0]};
    tf_adaptive_surface *surface;
    tf_outcome outcome;
    TF_REQUIRE(tf_adaptive_create(&mesh, places[0], &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_adaptive_merge(surface, (const int[]){0, 2},
                                 (const int[]){4, 6}, &outcome) == TF_OK);
    TF_REQUIRE(outcome == TF_COMMITTED);
    int count = 0;
    for (int t = 0; t < surface->triangles; t++) {
        const int *v = tf_triangle(surface, t);
        for (int i = 0; i < 3 && *v != TF_NONE; i++)
            tube[count][i] = v[i];
        count += *v != TF_NONE;
    }
    tf_adaptive_free(surface);
    return count;
}

static void draw_state(fig_page *page, int state, const int tube[TUBE][3])
{
    static const int low[] = {0, 1, 2, 3}, high[] = {4, 5, 6, 7};
    static const char *const titles[STATES] = {"before", "the ball", "after"};
    double width = fig_page_width(page) / STATES;
    fig_box box = {width * state, 16, width, fig_page_height(page) - 16};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = 22, .elevation = 20});
    fig_panel_margin(panel, 10);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[CORNERS];
    for (int v = 0; v < CORNERS; v++) {
        at[v] = fig_vector_of(places[v]);
        fig_scene_ball(scene, at[v], 4, (fig_paint){.role = FIG_ROLE_TRIANGLE});
    }
    fig_paint green = {.role = FIG_ROLE_TRIANGLE, .opacity = 0.8};
    fig_paint blue = {.role = FIG_ROLE_EDGE, .opacity = 0.25};
    if (state < 2)
        fig_patch_triangles(scene, at, WALLS, walls, state == 0 ? green : blue);
    if (state > 0)
        fig_patch_triangles(scene, at, TUBE, tube, state == 2 ? green : blue);
    fig_paint dark = {.role = FIG_ROLE_TRIANGLE, .shade = 0.35};
    fig_patch_outline(scene, at, 4, low, dark);
    fig_patch_outline(scene, at, 4, high, dark);
    fig_page_text(page, width * (state + 0.5), 12, FIG_ALIGN_CENTER,
                  titles[state], FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    int tube[TUBE][3], count = merge(tube);
    for (int state = 0; state < STATES; state++)
        draw_state(page, state, (const int(*)[3])tube);
    fig_number(numbers, "corners", CORNERS);
    fig_number(numbers, "walls", WALLS);
    fig_number(numbers, "tube", count);
    fig_number(numbers, "triangles", WALLS + count);
}

const fig_figure fig_merge_stages = {
    .name = "merge-stages",
    .title = "A merge: walls, ball and tube",
    .width = FIG_PAGE_WIDTH,
    .height = 126,
    .draw = draw,
};
