// What a triangle sweeps in plane space-time: a prism of three tetrahedra.
#include "figures.h"

#include "arithmetic/exact.h"
#include "spacetime/sweep.h"
#include "stage/vector.h"
#include "worlds.h"

enum {
    CORNERS = 4
};

/// How a step of the staircase is lettered and coloured.
typedef struct stair {
    const char *key, *letters;
    tf_role role;
} stair;

static const stair stairs[TF_VERTICES] = {
    {"volume_abcc", "$(a b c | c')$", TF_ROLE_START},
    {"volume_abbc", "$(a b | b' c')$", TF_ROLE_TRIANGLE},
    {"volume_aabc", "$(a | a' b' c')$", TF_ROLE_END},
};

/// Looks at the middle of the prism.
static const tf_camera camera = {.azimuth = 12,
                                 .elevation = 17,
                                 .height = 1.86,
                                 .center = {0.34, 0.28, 0.5}};

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
        int first = i <= simplex->mover ? 0 : simplex->mover + 1;
        if (i == first)
            continue;
        d.to[d.n] = simplex->event[i];
        d.from[d.n++] = simplex->event[first];
    }
    tf_value value = tf_exact.value(&d);
    return fabs(ldexp(value.number, value.exponent)) / 6;
}

/// An event of the triangle's vertex with that index, with its letter.
static void draw_event(tf_panel *panel, const tf_event *event, int vertex)
{
    static const char *const name[2][TF_VERTICES] = {{"$a$", "$b$", "$c$"},
                                                     {"$a'$", "$b'$", "$c'$"}};
    static const tf_side side[2][TF_VERTICES] = {
        {TF_SIDE_W, TF_SIDE_S, TF_SIDE_E}, {TF_SIDE_W, TF_SIDE_SW, TF_SIDE_N}};
    double at[3];
    tf_world_of_event(event, at);
    tf_scene_ball(tf_panel_scene(panel), at, 5,
                  (tf_paint){.role = TF_ROLE_TRIANGLE});
    tf_panel_label(panel, at,
                   (tf_label){.text = name[event->t][vertex],
                              .side = side[event->t][vertex],
                              .gap = 4});
}

static void draw_solid(tf_scene *scene, const tf_simplex *simplex, tf_role role)
{
    double corner[CORNERS][3];
    tf_world_of_simplex(simplex, corner);
    tf_scene_tetrahedron(
        scene, (const double(*)[3])corner, TF_WIDTH_THIN,
        (tf_paint){.role = role, .opacity = 0.8, .shade = -0.35});
}

/// The outline of the whole prism.
static void draw_outline(tf_scene *scene, const tf_worldline triangle[])
{
    tf_paint faint = {.role = TF_ROLE_NEUTRAL, .opacity = 0.6};
    for (int i = 0; i < TF_VERTICES; i++) {
        double here[2][3], next[2][3];
        for (int t = 0; t < 2; t++) {
            tf_world_of_event(&triangle[i].at[t], here[t]);
            tf_world_of_event(&triangle[(i + 1) % TF_VERTICES].at[t], next[t]);
            tf_scene_dashes(scene, here[t], next[t], TF_WIDTH_HAIR, 2, faint);
        }
        tf_scene_dashes(scene, here[0], here[1], TF_WIDTH_HAIR, 2, faint);
    }
}

static tf_panel *begin_panel(tf_page *page, double left, double width)
{
    tf_panel *panel =
        tf_page_panel(page, (tf_box){left, 0, width, panel_height});
    tf_panel_look(panel, camera);
    return panel;
}

static void draw_axis(tf_page *page)
{
    tf_panel *panel = begin_panel(page, 0, axis_width);
    tf_panel_fix(panel);
    tf_panel_axes(panel, (double[]){camera.center[0], camera.center[1], 0},
                  (double[]){0, 0, 0.5}, (const char *[]){NULL, NULL, "$t$"});
}

static void draw_whole(tf_panel *panel, const tf_worldline triangle[],
                       const tf_simplex sweep[])
{
    for (int i = 0; i < TF_VERTICES; i++) {
        draw_solid(tf_panel_scene(panel), &sweep[i], stairs[i].role);
        for (int t = 0; t < 2; t++)
            draw_event(panel, &triangle[i].at[t], i);
    }
}

/// One tetrahedron, in the outline of the prism.
static void draw_part(tf_panel *panel, const tf_worldline triangle[],
                      const tf_simplex *simplex, tf_role role)
{
    draw_outline(tf_panel_scene(panel), triangle);
    draw_solid(tf_panel_scene(panel), simplex, role);
    for (int i = 0; i < CORNERS; i++)
        draw_event(panel, simplex->event[i], i <= simplex->mover ? i : i - 1);
}

static void draw(tf_page *page, FILE *numbers)
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
        tf_page_text(page, left, panel_height / 2, TF_ALIGN_CENTER,
                     i == 0 ? "$=$" : "$+$", 16, TF_ROLE_INK);
        tf_page_text(page, left + place_width / 2, panel_height,
                     TF_ALIGN_CENTER, stairs[i].letters, TF_LETTERS,
                     TF_ROLE_INK);
        double volume = volume_of(&sweep[i]);
        tf_figure_number(numbers, stairs[i].key, volume);
        sum += volume;
    }
    tf_figure_number(numbers, "volume", sum);
}

const tf_figure tf_figure_prism = {
    .name = "prism",
    .title = "The prism that a triangle sweeps, in three tetrahedra",
    .width = TF_FIGURE_WIDTH,
    .height = 180,
    .draw = draw,
};
