// What a triangle sweeps in plane space-time: a prism of three tetrahedra.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "geometry/sweep.h"
#include "kit/worlds.h"

enum {
    CORNERS = 4
};

/// How a step of the staircase is lettered and colored.
typedef struct stair {
    const char *key, *letters;
    fig_role role;
} stair;

static const stair stairs[TF_VERTICES] = {
    {"volume_abcc", "$S_2 = (a b c | c')$", FIG_ROLE_START},
    {"volume_abbc", "$S_1 = (a b | b' c')$", FIG_ROLE_TRIANGLE},
    {"volume_aabc", "$S_0 = (a | a' b' c')$", FIG_ROLE_END},
};

/// Looks at the middle of the prism.
static const fig_camera camera = {.azimuth = 12,
                                  .elevation = 17,
                                  .height = 1.86,
                                  .center = {{0.34, 0.28, 0.5}}};

/// The prism and its parts stand side by side, behind the axis of time.
static const double axis_width = 26, place_width = 83.5, panel_height = 160;

static void make_triangle(tf_worldline triangle[TF_VERTICES])
{
    triangle[0] =
        tf_worldline_between(2, (double[]){0, 0.35}, (double[]){0.05, 0.25});
    triangle[1] =
        tf_worldline_between(2, (double[]){0.4, 0}, (double[]){0.5, 0.05});
    triangle[2] =
        tf_worldline_between(2, (double[]){0.7, 0.5}, (double[]){0.65, 0.6});
}

/// The volume of a tetrahedron of plane space-time: a sixth of the determinant
/// of its edges within t = 0 and within t = 1.
static double volume_of(const tf_simplex *simplex)
{
    tf_differences d = {.axis = {0, 1}};
    for (int i = 0; i < simplex->count; i++) {
        int first = i <= simplex->pivot ? 0 : simplex->pivot + 1;
        if (i == first)
            continue;
        d.to[d.n] = simplex->event[i];
        d.from[d.n++] = simplex->event[first];
    }
    tf_value value = tf_exact.value(&d);
    return fabs(ldexp(value.number, value.exponent)) / 6;
}

/// An event of the triangle's vertex with that index, with its letter.
static void draw_event(fig_panel *panel, const tf_event *event, int vertex)
{
    static const char *const name[2][TF_VERTICES] = {{"$a$", "$b$", "$c$"},
                                                     {"$a'$", "$b'$", "$c'$"}};
    static const fig_side side[2][TF_VERTICES] = {
        {FIG_SIDE_W, FIG_SIDE_S, FIG_SIDE_E},
        {FIG_SIDE_W, FIG_SIDE_SW, FIG_SIDE_N}};
    tf_vector at = fig_world_of_event(event);
    fig_scene_ball(fig_panel_scene(panel), at, 5,
                   (fig_paint){.role = FIG_ROLE_TRIANGLE});
    fig_panel_label(panel, at,
                    (fig_label){.text = name[event->t][vertex],
                                .side = side[event->t][vertex],
                                .gap = 4});
}

static void draw_solid(fig_scene *scene, const tf_simplex *simplex,
                       fig_role role)
{
    tf_vector corner[CORNERS];
    fig_world_of_simplex(simplex, corner);
    fig_scene_tetrahedron(
        scene, corner, FIG_WIDTH_THIN,
        (fig_paint){.role = role, .opacity = 0.8, .shade = -0.35});
}

/// The outline of the whole prism.
static void draw_outline(fig_scene *scene, const tf_worldline triangle[])
{
    fig_paint faint = {.role = FIG_ROLE_NEUTRAL, .opacity = 0.6};
    for (int i = 0; i < TF_VERTICES; i++) {
        const tf_worldline *next = &triangle[(i + 1) % TF_VERTICES];
        tf_vector here[2];
        for (int t = 0; t < 2; t++) {
            here[t] = fig_world_of_event(&triangle[i].at[t]);
            fig_scene_dashes(scene, here[t], fig_world_of_event(&next->at[t]),
                             FIG_WIDTH_HAIR, 2, faint);
        }
        fig_scene_dashes(scene, here[0], here[1], FIG_WIDTH_HAIR, 2, faint);
    }
}

static fig_panel *begin_panel(fig_page *page, double left, double width)
{
    fig_panel *panel =
        fig_page_panel(page, (fig_box){left, 0, width, panel_height});
    fig_panel_look(panel, camera);
    return panel;
}

static void draw_axis(fig_page *page)
{
    fig_panel *panel = begin_panel(page, 0, axis_width);
    fig_panel_fix(panel);
    tf_vector origin = camera.center;
    origin.x[2] = 0;
    fig_panel_axes(panel, origin, (tf_vector){{0, 0, 0.5}},
                   (const char *[]){NULL, NULL, "$t$"});
}

static void draw_whole(fig_panel *panel, const tf_worldline triangle[],
                       const tf_simplex sweep[])
{
    for (int i = 0; i < TF_VERTICES; i++) {
        draw_solid(fig_panel_scene(panel), &sweep[i], stairs[i].role);
        for (int t = 0; t < 2; t++)
            draw_event(panel, &triangle[i].at[t], i);
    }
}

/// One tetrahedron, in the outline of the prism.
static void draw_part(fig_panel *panel, const tf_worldline triangle[],
                      const tf_simplex *simplex, fig_role role)
{
    draw_outline(fig_panel_scene(panel), triangle);
    draw_solid(fig_panel_scene(panel), simplex, role);
    for (int i = 0; i < CORNERS; i++)
        draw_event(panel, simplex->event[i], i <= simplex->pivot ? i : i - 1);
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_worldline triangle[TF_VERTICES];
    tf_simplex sweep[TF_VERTICES];
    make_triangle(triangle);
    tf_sweep(TF_VERTICES, triangle, sweep);
    draw_axis(page);
    draw_whole(begin_panel(page, axis_width, place_width), triangle, sweep);
    double sum = 0;
    for (int i = 0; i < TF_VERTICES; i++) {
        double left = axis_width + (i + 1) * place_width;
        draw_part(begin_panel(page, left, place_width), triangle, &sweep[i],
                  stairs[i].role);
        fig_page_text(page, left, panel_height / 2, FIG_ALIGN_CENTER,
                      i == 0 ? "$=$" : "$+$", 16, FIG_ROLE_INK);
        fig_page_text(page, left + place_width / 2, panel_height,
                      FIG_ALIGN_CENTER, stairs[i].letters, FIG_LETTERS,
                      FIG_ROLE_INK);
        double volume = volume_of(&sweep[i]);
        fig_number(numbers, stairs[i].key, volume);
        sum += volume;
    }
    fig_number(numbers, "volume", sum);
}

const fig_figure fig_prism = {
    .name = "prism",
    .title = "The prism that a triangle sweeps, in three tetrahedra",
    .width = FIG_PAGE_WIDTH,
    .height = 180,
    .draw = draw,
};
