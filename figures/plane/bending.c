// A bent edge and a bent triangle as they move.
#include "kit/figures.h"

#include "geometry/sweep.h"
#include "kit/film.h"
#include "kit/worlds.h"

static const double still = 0.5;

/// A piece is coloured by the time at which all of the element lies as it does.
static const fig_role piece_role[TF_VERTICES + 1][TF_VERTICES] = {
    [2] = {FIG_ROLE_START, FIG_ROLE_END},
    [3] = {FIG_ROLE_START, FIG_ROLE_TRIANGLE, FIG_ROLE_END}};

typedef struct element {
    int axes, vertices;
    tf_worldline vertex[TF_VERTICES];
    const char *name[TF_VERTICES];
    double dx[TF_VERTICES], dy[TF_VERTICES];
    fig_role role;
    fig_camera camera;
    fig_box box;
} element;

static element make_edge(void)
{
    return (element){
        .axes = 2,
        .vertices = 2,
        .vertex = {tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 1}),
                   tf_worldline_between(2, (double[]){4, 0}, (double[]){4, 2})},
        .name = {"$v_0$", "$v_1$"},
        .dx = {-11, 11},
        .role = FIG_ROLE_EDGE,
        .camera = {.elevation = 90},
        .box = {4, 20, 184, 118}};
}

static element make_triangle(void)
{
    return (element){
        .axes = 3,
        .vertices = 3,
        .vertex = {tf_worldline_between(3, (double[]){-0.6, -0.3, 0},
                                        (double[]){-0.5, -0.4, 0.8}),
                   tf_worldline_between(3, (double[]){0.6, -0.4, 0},
                                        (double[]){0.6, -0.3, 0.1}),
                   tf_worldline_between(3, (double[]){0, 0.6, 0},
                                        (double[]){0.1, 0.5, -0.3})},
        .name = {"$v_0$", "$v_1$", "$v_2$"},
        .dx = {10, -11, 10},
        .dy = {-4, 0, 4},
        .role = FIG_ROLE_TRIANGLE,
        .camera = {.azimuth = 150, .elevation = 36},
        .box = {196, 20, 184, 118}};
}

/// A flat piece, which has an extent, and its border.
static void draw_piece(fig_scene *scene, const fig_slice *piece, fig_role role)
{
    const fig_paint paint = {.role = role, .shade = -0.2};
    if (piece->count == 2) {
        fig_scene_tube(scene, piece->corner[0], piece->corner[1],
                       FIG_WIDTH_TUBE, paint);
        return;
    }
    for (int i = 2; i < piece->count; i++)
        fig_scene_triangle(scene,
                           (tf_vector[]){piece->corner[0], piece->corner[i - 1],
                                         piece->corner[i]},
                           0, paint);
    for (int i = 0; i < piece->count; i++)
        fig_scene_tube(scene, piece->corner[i],
                       piece->corner[(i + 1) % piece->count], FIG_WIDTH_LINE,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE, .shade = 0.3});
}

/// Where the element is at an end of the step, dashed.
static void draw_outline(fig_scene *scene, const element *e, int t)
{
    const fig_paint paint = {.role = t ? FIG_ROLE_END : FIG_ROLE_START};
    int sides = e->vertices == 2 ? 1 : e->vertices;
    for (int i = 0; i < sides; i++)
        fig_scene_dashes(
            scene, fig_worldline_place(&e->vertex[i], e->axes, t),
            fig_worldline_place(&e->vertex[(i + 1) % e->vertices], e->axes, t),
            FIG_WIDTH_HAIR, 2, paint);
}

static void draw_element(fig_page *page, const element *e, double t)
{
    fig_page_fill_box(page, e->box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, e->box);
    fig_panel_look(panel, e->camera);
    fig_panel_margin(panel, e->axes == 2 ? 22 : 14);
    if (e->axes == 2)
        fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    for (int end = 0; end < 2; end++)
        draw_outline(scene, e, end);
    tf_simplex sweep[TF_VERTICES];
    tf_sweep(e->vertices, e->vertex, sweep);
    for (int i = 0; i < e->vertices; i++) {
        fig_slice piece = fig_slice_of(&sweep[i], e->axes, t);
        draw_piece(scene, &piece, piece_role[e->vertices][i]);
    }
    for (int i = 0; i < e->vertices; i++) {
        tf_vector now = fig_worldline_place(&e->vertex[i], e->axes, t);
        fig_scene_dashes(scene, fig_worldline_place(&e->vertex[i], e->axes, 0),
                         fig_worldline_place(&e->vertex[i], e->axes, 1),
                         FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
        fig_scene_ball(scene, now, 5, (fig_paint){.role = e->role});
        fig_film_name(page, panel, now, e->dx[i], e->dy[i], e->name[i],
                      FIG_ROLE_INK);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    const element edge = make_edge(), triangle = make_triangle();
    double t = fig_film_time(page, numbers, still, -1);
    draw_element(page, &edge, t);
    draw_element(page, &triangle, t);
    fig_page_title(page, edge.box, "an edge");
    fig_page_title(page, triangle.box, "a triangle");
    fig_film_clock(page, 4, 160, FIG_PAGE_WIDTH - 8, t, -1, NULL);
}

const fig_figure fig_bending = {
    .name = "bending",
    .title = "A bent edge and a bent triangle in motion",
    .width = FIG_PAGE_WIDTH,
    .height = 170,
    .moves = true,
    .draw = draw,
};
