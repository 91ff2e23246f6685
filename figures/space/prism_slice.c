// The prism of a triangle in plane space-time, cut at a time, and the slice:
// pieces of three tetrahedra, two triangles and a parallelogram between them.
#include "kit/figures.h"

#include "geometry/sweep.h"
#include "kit/film.h"
#include "kit/worlds.h"

static const double still = 0.5;

static const fig_role role[TF_VERTICES] = {FIG_ROLE_START, FIG_ROLE_TRIANGLE,
                                           FIG_ROLE_END};

static const fig_box solid_box = {0, 4, 186, 186},
                     slice_box = {196, 22, 184, 146};

static void make_triangle(tf_worldline triangle[TF_VERTICES])
{
    triangle[0] =
        tf_worldline_between(2, (double[]){0, 0.3}, (double[]){0.1, 0.1});
    triangle[1] =
        tf_worldline_between(2, (double[]){0.45, 0}, (double[]){0.7, 0.05});
    triangle[2] =
        tf_worldline_between(2, (double[]){0.75, 0.5}, (double[]){0.6, 0.65});
}

static tf_vector place_at(const tf_worldline *vertex, double t, double height)
{
    tf_vector place = fig_worldline_place(vertex, 2, t);
    place.x[2] = height;
    return place;
}

/// The border of the prism, and its plane at the time t.
static void draw_frame(fig_scene *scene, const tf_worldline triangle[],
                       double t)
{
    const fig_paint faint = {.role = FIG_ROLE_NEUTRAL};
    for (int i = 0; i < TF_VERTICES; i++) {
        const tf_worldline *next = &triangle[(i + 1) % TF_VERTICES];
        for (int end = 0; end < 2; end++)
            fig_scene_tube(scene, place_at(&triangle[i], end, end),
                           place_at(next, end, end), FIG_WIDTH_LINE, faint);
        fig_scene_tube(scene, place_at(&triangle[i], 0, 0),
                       place_at(&triangle[i], 1, 1), FIG_WIDTH_LINE, faint);
    }
    fig_scene_grid(scene, (tf_vector){{-0.06, -0.06, t}},
                   (tf_vector){{0.87, 0, 0}}, (tf_vector){{0, 0.77, 0}}, 1, 1,
                   FIG_ROLE_NEUTRAL);
}

/// A piece of the slice at a height, and its border.
static void draw_piece(fig_scene *scene, fig_slice slice, double height,
                       fig_role own)
{
    for (int i = 0; i < slice.count; i++)
        slice.corner[i].x[2] = height;
    for (int i = 2; i < slice.count; i++)
        fig_scene_triangle(scene,
                           (tf_vector[]){slice.corner[0], slice.corner[i - 1],
                                         slice.corner[i]},
                           0, (fig_paint){.role = own, .shade = -0.25});
    for (int i = 0; i < slice.count; i++)
        fig_scene_tube(scene, slice.corner[i],
                       slice.corner[(i + 1) % slice.count], FIG_WIDTH_LINE,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE, .shade = 0.3});
}

static void draw_solid(fig_page *page, const tf_worldline triangle[],
                       const tf_simplex sweep[], double t)
{
    static const char *const name[2][TF_VERTICES] = {{"$a$", "$b$", "$c$"},
                                                     {"$a'$", "$b'$", "$c'$"}};
    static const double dx[TF_VERTICES] = {-10, -2, 10},
                        dy[2][TF_VERTICES] = {{0, 10, 3}, {-4, -9, -4}};
    fig_panel *panel = fig_page_panel(page, solid_box);
    fig_panel_look(panel, (fig_camera){.azimuth = 12, .elevation = 20});
    fig_panel_margin(panel, 18);
    fig_scene *scene = fig_panel_scene(panel);
    for (int k = 0; k < 4; k++)
        for (int end = 0; end < 2; end++)
            fig_scene_reach(scene, (tf_vector){{k % 2 ? 0.81 : -0.06,
                                                k / 2 ? 0.71 : -0.06, end}});
    draw_frame(scene, triangle, t);
    for (int i = 0; i < TF_VERTICES; i++) {
        tf_vector corner[4];
        fig_world_of_simplex(&sweep[i], corner);
        fig_scene_tetrahedron(scene, corner, FIG_WIDTH_HAIR,
                              (fig_paint){.role = role[i], .opacity = 0.22});
        draw_piece(scene, fig_slice_of(&sweep[i], 2, t), t, role[i]);
    }
    for (int i = 0; i < TF_VERTICES; i++)
        for (int end = 0; end < 2; end++)
            fig_film_name(page, panel, place_at(&triangle[i], end, end), dx[i],
                          dy[end][i], name[end][i], FIG_ROLE_INK);
}

static void draw_slice(fig_page *page, const tf_worldline triangle[],
                       const tf_simplex sweep[], double t)
{
    fig_page_fill_box(page, slice_box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_panel *panel = fig_page_panel(page, slice_box);
    fig_panel_look(panel, (fig_camera){.elevation = 90});
    fig_panel_margin(panel, 12);
    fig_panel_fix(panel);
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i < TF_VERTICES; i++) {
        for (int end = 0; end < 2; end++)
            fig_scene_dashes(
                scene, place_at(&triangle[i], end, 0),
                place_at(&triangle[(i + 1) % 3], end, 0), FIG_WIDTH_HAIR, 2,
                (fig_paint){.role = end ? FIG_ROLE_END : FIG_ROLE_START});
        fig_scene_dashes(scene, place_at(&triangle[i], 0, 0),
                         place_at(&triangle[i], 1, 0), FIG_WIDTH_HAIR, 2,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL});
        draw_piece(scene, fig_slice_of(&sweep[i], 2, t), 0, role[i]);
    }
    fig_page_title(page, slice_box, "the slice");
}

/// Of a polygon without a fold.
static double area_of(const fig_slice *slice)
{
    double doubled = 0;
    for (int i = 0; i < slice->count; i++)
        doubled +=
            fig_cross(slice->corner[i], slice->corner[(i + 1) % slice->count])
                .x[2];
    return fabs(doubled) / 2;
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const key[TF_VERTICES] = {"area_start", "area_between",
                                                 "area_end"};
    tf_worldline triangle[TF_VERTICES];
    tf_simplex sweep[TF_VERTICES];
    make_triangle(triangle);
    tf_sweep(TF_VERTICES, triangle, sweep);
    double t = fig_film_time(page, numbers, still, -1);
    draw_solid(page, triangle, sweep, t);
    draw_slice(page, triangle, sweep, t);
    fig_film_clock(page, 4, 196, FIG_PAGE_WIDTH - 8, t, -1, NULL);
    for (int i = 0; i < TF_VERTICES; i++) {
        fig_slice slice = fig_slice_of(&sweep[i], 2, still);
        fig_number(numbers, key[i], area_of(&slice));
    }
}

const fig_figure fig_prism_slice = {
    .name = "prism-slice",
    .title = "The prism of a triangle, cut at a time",
    .width = FIG_PAGE_WIDTH,
    .height = 206,
    .moves = true,
    .draw = draw,
};
