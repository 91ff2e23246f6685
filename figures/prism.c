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

static const double azimuth = 12;

/// How far apart the prism and its parts stand.
static const double apart = 0.97;

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

/// Move a point of the world to the `place`-th place from the left, as seen.
static void shift(double place, double world[3])
{
    double angle = azimuth * acos(-1) / 180;
    double right[3] = {cos(angle), sin(angle), 0};
    tf_add(world, place * apart, right, world);
}

/// Where an event is in the world, at that place.
static void find_place(const tf_event *event, double place, double world[3])
{
    tf_world_of_event(event, world);
    shift(place, world);
}

/// An event of the triangle's vertex with that index, with its letter.
static void draw_event(tf_panel *panel, const tf_event *event, int vertex,
                       double place)
{
    static const char *const name[2][TF_VERTICES] = {{"$a$", "$b$", "$c$"},
                                                     {"$a'$", "$b'$", "$c'$"}};
    static const tf_side side[2][TF_VERTICES] = {
        {TF_SIDE_W, TF_SIDE_S, TF_SIDE_E}, {TF_SIDE_W, TF_SIDE_SW, TF_SIDE_N}};
    double at[3];
    find_place(event, place, at);
    tf_scene_ball(tf_panel_scene(panel), at, 5,
                  (tf_paint){.role = TF_ROLE_TRIANGLE});
    tf_panel_label(panel, at,
                   (tf_label){.text = name[event->t][vertex],
                              .side = side[event->t][vertex],
                              .gap = 4});
}

/// One tetrahedron, at that place.
static void draw_solid(tf_scene *scene, const tf_simplex *simplex, tf_role role,
                       double place)
{
    double corner[CORNERS][3];
    for (int i = 0; i < CORNERS; i++)
        find_place(simplex->event[i], place, corner[i]);
    tf_scene_tetrahedron(
        scene, (const double(*)[3])corner, TF_WIDTH_THIN,
        (tf_paint){.role = role, .opacity = 0.8, .shade = -0.35});
}

/// The outline of the whole prism, at that place.
static void draw_outline(tf_scene *scene, const tf_worldline triangle[],
                         double place)
{
    tf_paint faint = {.role = TF_ROLE_NEUTRAL, .opacity = 0.6};
    for (int i = 0; i < TF_VERTICES; i++) {
        double here[2][3], next[2][3];
        for (int t = 0; t < 2; t++) {
            find_place(&triangle[i].at[t], place, here[t]);
            find_place(&triangle[(i + 1) % TF_VERTICES].at[t], place, next[t]);
            tf_scene_dashes(scene, here[t], next[t], TF_WIDTH_HAIR, 2, faint);
        }
        tf_scene_dashes(scene, here[0], here[1], TF_WIDTH_HAIR, 2, faint);
    }
}

/// Text below a place, or a sign between two of them.
static void draw_text(tf_page *page, const tf_panel *panel, double place,
                      double height, const char *text, double size)
{
    double world[3] = {0.34, 0.28, 0.5}, at[2];
    shift(place, world);
    tf_panel_project(panel, world, at);
    tf_page_text(page, at[0], at[1] - height, TF_ALIGN_CENTER, text, size,
                 TF_ROLE_INK);
}

/// The whole prism at the first place, its tetrahedra at those to the right.
static void draw_prism(tf_panel *panel, const tf_worldline triangle[],
                       const tf_simplex sweep[])
{
    tf_scene *scene = tf_panel_scene(panel);
    for (int i = 0; i < TF_VERTICES; i++) {
        draw_solid(scene, &sweep[i], stairs[i].role, 0);
        draw_solid(scene, &sweep[i], stairs[i].role, i + 1);
        draw_outline(scene, triangle, i + 1);
        for (int t = 0; t < 2; t++)
            draw_event(panel, &triangle[i].at[t], i, 0);
    }
    for (int i = 0; i < TF_VERTICES; i++)
        for (int j = 0; j < CORNERS; j++)
            draw_event(panel, sweep[i].event[j],
                       j <= sweep[i].mover ? j : j - 1, i + 1);
}

static void draw(tf_page *page, FILE *numbers)
{
    tf_worldline triangle[TF_VERTICES];
    tf_simplex sweep[TF_VERTICES];
    make_triangle(triangle);
    tf_sweep(TF_VERTICES, triangle, sweep);
    tf_panel *panel = tf_page_panel(
        page, (tf_box){0, 0, tf_page_width(page), tf_page_height(page) - 20});
    tf_panel_look(panel, (tf_camera){.azimuth = azimuth, .elevation = 17});
    tf_panel_margin(panel, 16);
    tf_panel_fix(panel);
    tf_panel_axes(panel, (double[]){-0.2, 0.3, 0}, (double[]){0, 0, 0.5},
                  (const char *[]){NULL, NULL, "$t$"});
    draw_prism(panel, triangle, sweep);
    double sum = 0;
    for (int i = 0; i < TF_VERTICES; i++) {
        double volume = volume_of(&sweep[i]);
        tf_figure_number(numbers, stairs[i].key, volume);
        sum += volume;
        draw_text(page, panel, i + 1, -79, stairs[i].letters, TF_LETTERS);
        draw_text(page, panel, i + 0.5, 0, i == 0 ? "$=$" : "$+$", 16);
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
