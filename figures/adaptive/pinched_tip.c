// A tip that is pinched off, and whose loop goes to the other side of it.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/patches.h"

#include "topology/pinch.h"

#include <math.h>

enum {
    LOOP = 3,
    TIP = 3,
    VERTICES = 6,
    PLACES = VERTICES + LOOP,
    TRIANGLES = 8,
    STATES = 2
};

static const double places[VERTICES][3] = {{1, 0, 0},     {-0.8, 1, 0},
                                           {-0.8, -1, 0}, {0, 0, 1},
                                           {0.1, 0, -1},  {-0.1, 0, -2}};

/// Those of the tip come first.
static const int triangles[TRIANGLES][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3},
                                            {1, 0, 4}, {4, 0, 2}, {1, 4, 5},
                                            {4, 2, 5}, {2, 1, 5}};
static const int caps[2][3] = {{0, 1, 2},
                               {VERTICES, VERTICES + 2, VERTICES + 1}};

/// How far the copies of the loop go up, and how far they may go.
static const double too_far = 2.1, fine = 0.3;

static const fig_camera camera = {.azimuth = 20, .elevation = 14};

static tf_outcome pinch(double up)
{
    static const int loop[LOOP] = {0, 1, 2};
    const tf_mesh mesh = {.axes = 3,
                          .vertices = VERTICES,
                          .triangles = TRIANGLES,
                          .triangle = triangles[0]};
    double place[3 * LOOP];
    int vertex[LOOP];
    tf_adaptive_surface *surface;
    tf_outcome outcome;
    for (int i = 0; i < 3 * LOOP; i++)
        place[i] = places[i / 3][i % 3] + (i % 3 == 2 ? up : 0);
    TF_REQUIRE(tf_adaptive_create(&mesh, places[0], &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_adaptive_pinch(surface, loop, place, vertex, &outcome) ==
               TF_OK);
    tf_adaptive_free(surface);
    return outcome;
}

static void make_places(double up, tf_vector at[PLACES])
{
    for (int v = 0; v < VERTICES; v++)
        at[v] = fig_vector_of(places[v]);
    for (int i = 0; i < LOOP; i++)
        at[VERTICES + i] = fig_sum(at[i], (tf_vector){{0, 0, up}});
}

/// The signed volume of what is cut off.
static double volume_of_tip(double up)
{
    tf_vector at[PLACES];
    make_places(up, at);
    tf_vector u = fig_difference(at[VERTICES + 1], at[VERTICES]);
    tf_vector v = fig_difference(at[VERTICES + 2], at[VERTICES]);
    tf_vector w = fig_difference(at[TIP], at[VERTICES]);
    return tf_vector_dot(fig_cross(u, v), w) / 6;
}

static tf_vector to_the_eye(void)
{
    double azimuth = camera.azimuth * acos(-1) / 180;
    double elevation = camera.elevation * acos(-1) / 180;
    return (tf_vector){{sin(azimuth) * cos(elevation),
                        -cos(azimuth) * cos(elevation), sin(elevation)}};
}

/// Blue from outside, orange from inside.
static void draw_face(fig_scene *scene, const tf_vector at[],
                      const int corner[3])
{
    tf_vector x[3];
    for (int i = 0; i < 3; i++)
        x[i] = at[corner[i]];
    tf_vector normal =
        fig_cross(fig_difference(x[1], x[0]), fig_difference(x[2], x[0]));
    bool outside = tf_vector_dot(normal, to_the_eye()) > 0;
    fig_scene_triangle(
        scene, x, FIG_WIDTH_LINE,
        (fig_paint){.role = outside ? FIG_ROLE_EDGE : FIG_ROLE_OTHER_EDGE});
}

/// The tip and, of the loop or its copies, the corners that can be seen.
static void draw_names(fig_panel *panel, int state, const tf_vector at[])
{
    static const fig_side sides[LOOP] = {FIG_SIDE_E, FIG_SIDE_N, FIG_SIDE_W};
    static const char *const names[STATES][LOOP] = {{"$a$", "$b$", "$c$"},
                                                    {"$a'$", "$b'$", "$c'$"}};
    for (int i = 0; i < LOOP; i++)
        if (state == 1 || sides[i] != FIG_SIDE_N)
            fig_panel_label(panel, at[i + (state == 1 ? VERTICES : 0)],
                            (fig_label){.text = names[state][i],
                                        .size = FIG_LETTERS_SMALL,
                                        .side = sides[i],
                                        .gap = 4});
    fig_panel_label(panel, at[TIP],
                    (fig_label){.text = "$t$",
                                .role = FIG_ROLE_POINT,
                                .size = FIG_LETTERS_SMALL,
                                .side = state == 1 ? FIG_SIDE_E : FIG_SIDE_N});
}

static void draw_state(fig_page *page, int state)
{
    static const char *const titles[STATES] = {"a tip", "beyond the tip"};
    static const int loop[] = {0, 1, 2};
    double width = fig_page_width(page) / STATES;
    fig_box box = {width * state, 18, width, fig_page_height(page) - 18};
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_panel_fix(panel);
    fig_panel_margin(panel, 14);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    make_places(too_far, at);
    for (int v = 0; v < PLACES; v++)
        fig_scene_reach(scene, at[v]);
    for (int t = 0; t < TRIANGLES; t++) {
        int corner[3];
        for (int i = 0; i < 3; i++) {
            int v = triangles[t][i];
            bool moves = state == 1 && t < LOOP && v < LOOP;
            corner[i] = v + (moves ? VERTICES : 0);
        }
        draw_face(scene, at, corner);
    }
    for (int i = 0; i < 2 && state == 1; i++)
        draw_face(scene, at, caps[i]);
    fig_patch_outline(scene, at, LOOP, loop, (fig_paint){.role = FIG_ROLE_INK});
    fig_scene_ball(scene, at[TIP], FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    draw_names(panel, state, at);
    fig_page_title(page, box, titles[state]);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int state = 0; state < STATES; state++)
        draw_state(page, state);
    tf_outcome outcome = pinch(too_far);
    fig_number(numbers, "refused",
               outcome != TF_COMMITTED && outcome != TF_IMPOSSIBLE);
    fig_number(numbers, "fine", pinch(fine) == TF_COMMITTED);
    fig_number(numbers, "volume", volume_of_tip(too_far));
    fig_number(numbers, "volume_fine", volume_of_tip(fine));
}

const fig_figure fig_pinched_tip = {
    .name = "pinched-tip",
    .title = "A tip that is pinched off, and turned inside out",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
