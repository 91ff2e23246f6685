// A flip in motion: a vertex is inserted on the one edge, moves through the
// tetrahedron to the other one and is forgotten.
#include "kit/figures.h"
#include "kit/patches.h"

enum {
    SHOWN = 4,
    PLACES = 5
};

static const tf_vector places[PLACES - 1] = {
    {{-1, 0, 0}}, {{1, 0, 0}}, {{0.1, 0.9, 0.9}}, {{-0.1, -0.9, 0.9}}};

static void draw_time(fig_page *page, fig_box box, double t)
{
    static const int corner[] = {0, 1, 2, 3};
    static const int moving[4][3] = {
        {4, 2, 0}, {4, 1, 2}, {4, 3, 1}, {4, 0, 3}};
    static const char *const name[] = {"$a$", "$b$", "$c$", "$d$"};
    static const fig_side side[] = {FIG_SIDE_W, FIG_SIDE_E, FIG_SIDE_N,
                                    FIG_SIDE_N};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = -32, .elevation = 26});
    fig_panel_margin(panel, 14);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    for (int i = 0; i < PLACES - 1; i++)
        at[i] = places[i];
    at[4] =
        fig_lerp(fig_lerp(at[0], at[1], 0.5), fig_lerp(at[2], at[3], 0.5), t);
    fig_patch_triangles(scene, at, 4, moving,
                        (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.6});
    fig_patch_swept(scene, at, corner);
    fig_scene_ball(scene, at[4], FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    fig_panel_label(panel, at[4],
                    (fig_label){.text = "$q_t$",
                                .size = FIG_LETTERS_SMALL,
                                .side = t < 0.5 ? FIG_SIDE_S : FIG_SIDE_E,
                                .gap = 5});
    for (int i = 0; i < PLACES - 1; i++) {
        fig_scene_ball(scene, at[i], 4, (fig_paint){.role = FIG_ROLE_TRIANGLE});
        fig_panel_label(panel, at[i],
                        (fig_label){.text = name[i],
                                    .size = FIG_LETTERS_SMALL,
                                    .side = side[i],
                                    .gap = 4});
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / SHOWN;
    for (int i = 0; i < SHOWN; i++) {
        fig_box box = {width * i, 0, width, fig_page_height(page) - 16};
        char text[32];
        double t = (double)i / (SHOWN - 1);
        snprintf(text, sizeof text, i % 3 == 0 ? "$t = %g$" : "$t = %.2f$", t);
        draw_time(page, box, t);
        fig_page_caption(page, box, text);
    }
    fig_number(numbers, "times", SHOWN);
}

const fig_figure fig_flip_motion = {
    .name = "flip-motion",
    .title = "The motion of a flip, at four times",
    .width = FIG_PAGE_WIDTH,
    .height = 106,
    .draw = draw,
};
