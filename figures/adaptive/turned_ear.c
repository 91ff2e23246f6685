// An ear of a surface that turns over within its own plane: the edge opposite
// to one of its corners passes over the other end of the common edge.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/patches.h"

#include "surgery/move.h"

enum {
    SHOWN = 3,
    VERTICES = 4
};

/// v, x, y and z: the ear is vxy, and its neighbor yxz.
static const double places[VERTICES][3] = {
    {-0.9, 0, 0.8}, {-0.4, 0, 0}, {1, 0, 0}, {0.3, -1.2, 0.2}};
static const double end[3] = {-0.9, 0, -0.8};
static const int ear[1][3] = {{0, 1, 2}}, neighbor[1][3] = {{2, 1, 3}};

static tf_outcome try_move(void)
{
    static const int triangle[] = {0, 1, 2, 2, 1, 3};
    const tf_mesh mesh = {
        .axes = 3, .vertices = VERTICES, .triangles = 2, .triangle = triangle};
    tf_adaptive_surface *surface;
    tf_outcome outcome;
    TF_REQUIRE(tf_adaptive_create(&mesh, places[0], &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_adaptive_move(surface, 0, end, &outcome) == TF_OK);
    tf_adaptive_free(surface);
    return outcome;
}

static void draw_name(fig_panel *panel, tf_vector at, const char *name,
                      fig_side side)
{
    fig_panel_label(
        panel, at,
        (fig_label){
            .text = name, .size = FIG_LETTERS_SMALL, .side = side, .gap = 4});
}

static void draw_time(fig_page *page, fig_box box, double t)
{
    static const char *const name[] = {"$v_t$", "$x$", "$y$", "$z$"};
    static const fig_side side[] = {FIG_SIDE_W, FIG_SIDE_N, FIG_SIDE_E,
                                    FIG_SIDE_S};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = -25, .elevation = 22});
    fig_panel_fix(panel);
    fig_panel_margin(panel, 16);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[VERTICES];
    for (int i = 0; i < VERTICES; i++) {
        at[i] = fig_vector_of(places[i]);
        fig_scene_reach(scene, at[i]);
    }
    fig_scene_reach(scene, fig_vector_of(end));
    at[0] = fig_lerp(at[0], fig_vector_of(end), t);
    fig_patch_triangles(scene, at, 1, neighbor,
                        (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.7});
    fig_patch_triangles(
        scene, at, t == 0.5 ? 0 : 1, ear,
        (fig_paint){.role = t < 0.5 ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE,
                    .opacity = 0.8});
    if (t == 0.5)
        fig_scene_tube(scene, at[0], at[2], FIG_WIDTH_TUBE,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    for (int i = 0; i < VERTICES; i++) {
        fig_scene_ball(scene, at[i], i == 0 ? FIG_WIDTH_BALL : 4,
                       (fig_paint){.role = i == 0   ? FIG_ROLE_POINT
                                           : i == 1 ? FIG_ROLE_CONTACT
                                                    : FIG_ROLE_TRIANGLE});
        draw_name(panel, at[i], name[i], side[i]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / SHOWN;
    for (int i = 0; i < SHOWN; i++) {
        fig_box box = {width * i, 16, width, fig_page_height(page) - 18};
        char text[32];
        snprintf(text, sizeof text, "$t = %g$", 0.5 * i);
        draw_time(page, box, 0.5 * i);
        fig_page_title(page, box, text);
    }
    fig_number(numbers, "refused", try_move() == TF_PASSED_EDGE);
}

const fig_figure fig_turned_ear = {
    .name = "turned-ear",
    .title = "An ear that turns over within its own plane",
    .width = FIG_PAGE_WIDTH,
    .height = 140,
    .draw = draw,
};
