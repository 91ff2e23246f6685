// For each of the five tests a surgery that only it refuses.
#include "base/require.h"
#include "experiments/leave_out.h"
#include "kit/figures.h"
#include "kit/patches.h"

#include "surgery/adaptive_surface.h"
#include "surgery/flip.h"
#include "surgery/move.h"

#include <stdio.h>

enum {
    WITNESSES = 5,
    PLACES = 8,
    TRIANGLES = 8
};

/// A mesh, and an operation on it: a flip of the edge 0, 1, or a move of the
/// vertex 0.
typedef struct witness {
    const char *title, *key;
    tf_outcome refusal;
    bool flips;
    double end[3];
    int vertices, triangles;
    double place[PLACES][3];
    int triangle[TRIANGLES][3];
} witness;

static const witness witnesses[WITNESSES] = {
    {.title = "*D*",
     .key = "D",
     .refusal = TF_FLATTENED,
     .flips = true,
     .vertices = 6,
     .triangles = 4,
     .place = {{0, 1, 0},
               {0, 0, 0},
               {-1, 0, 0},
               {1, 0, 0},
               {-1, 1.1, 0},
               {1, 1.1, 0}},
     .triangle = {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}, {0, 3, 5}}},
    {.title = "*S*",
     .key = "S",
     .refusal = TF_OVERLAPPED,
     .flips = true,
     .vertices = 6,
     .triangles = 4,
     .place = {{0, 1, 0},
               {0, 0.4, 0},
               {-1, 0, 0},
               {1, 0, 0},
               {-1, 1.1, 0},
               {1, 1.1, 0}},
     .triangle = {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}, {0, 3, 5}}},
    {.title = "*V*",
     .key = "V",
     .refusal = TF_PASSED_VERTEX,
     .end = {-0.2, -0.2, 2.2},
     .vertices = 8,
     .triangles = 8,
     .place = {{1, 1, 1},
               {1, -1, -1},
               {-1, 1, -1},
               {-1, -1, 1},
               {0.12, -0.1, 0.95},
               {0.32, 0.1, 0.95},
               {0.32, -0.1, 1.15},
               {0.12, 0.1, 1.15}},
     .triangle = {{0, 1, 2},
                  {0, 2, 3},
                  {0, 3, 1},
                  {1, 3, 2},
                  {4, 5, 6},
                  {4, 6, 7},
                  {4, 7, 5},
                  {5, 7, 6}}},
    {.title = "*E*",
     .key = "E",
     .refusal = TF_PASSED_EDGE,
     .end = {0.5, 0.5, -3},
     .vertices = 4,
     .triangles = 4,
     .place = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
     .triangle = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}},
    {.title = "*X*",
     .key = "X",
     .refusal = TF_PASSED_TRIANGLE,
     .end = {-2, -2, -2},
     .vertices = 4,
     .triangles = 4,
     .place = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
     .triangle = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}}};

// Trying ----------------------------------------------------------------------

/// What becomes of a witness if these tests are left out.
static tf_outcome try_it(const witness *w, unsigned left_out)
{
    const tf_mesh mesh = {.axes = 3,
                          .vertices = w->vertices,
                          .triangles = w->triangles,
                          .triangle = w->triangle[0]};
    tf_adaptive_surface *surface;
    TF_REQUIRE(tf_adaptive_create(&mesh, w->place[0], &surface, NULL) == TF_OK);
    tf_outcome outcome;
    leave_out(left_out);
    tf_status status = w->flips
                           ? tf_adaptive_flip(surface, 0, 1, &outcome)
                           : tf_adaptive_move(surface, 0, w->end, &outcome);
    leave_out(0);
    TF_REQUIRE(status == TF_OK);
    tf_adaptive_free(surface);
    return outcome;
}

static void print_numbers(FILE *numbers, const witness *w)
{
    char key[32];
    snprintf(key, sizeof key, "%s_refused", w->key);
    fig_number(numbers, key, try_it(w, 0) == w->refusal);
    snprintf(key, sizeof key, "%s_alone", w->key);
    fig_number(numbers, key, try_it(w, 1U << w->refusal) == TF_COMMITTED);
}

// Drawing ---------------------------------------------------------------------

static const fig_paint green = {.role = FIG_ROLE_TRIANGLE, .opacity = 0.5};
static const fig_paint red = {.role = FIG_ROLE_CONTACT, .opacity = 0.75};

static void name_place(fig_panel *panel, tf_vector at, const char *text,
                       fig_side side)
{
    fig_panel_label(
        panel, at,
        (fig_label){
            .text = text, .size = FIG_LETTERS_SMALL, .side = side, .gap = 4});
}

/// A flip: what is kept and added, and the flipped edge and its new place.
static void draw_flip(fig_panel *panel, const witness *w)
{
    static const int kept[2][3] = {{0, 4, 2}, {0, 3, 5}};
    static const int upper[1][3] = {{3, 2, 0}}, lower[1][3] = {{2, 3, 1}};
    static const char *const name[] = {"$a$", "$b$", "$c$", "$d$"};
    static const fig_side side[] = {FIG_SIDE_N, FIG_SIDE_S, FIG_SIDE_W,
                                    FIG_SIDE_E};
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    for (int i = 0; i < w->vertices; i++)
        at[i] = fig_vector_of(w->place[i]);
    if (w->refusal == TF_OVERLAPPED)
        fig_patch_triangles(scene, at, 1, lower, red);
    fig_patch_triangles(scene, at, 2, kept, green);
    fig_patch_triangles(scene, at, 1, upper, green);
    fig_scene_tube(scene, at[2], at[3], FIG_WIDTH_TUBE,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
    fig_scene_dashes(scene, at[0], at[1], FIG_WIDTH_LINE, 3,
                     (fig_paint){.role = FIG_ROLE_INK});
    for (int i = 0; i < 4; i++) {
        fig_scene_ball(
            scene, at[i], i == 1 ? FIG_WIDTH_BALL : 4,
            (fig_paint){.role = i == 1 ? FIG_ROLE_CONTACT : FIG_ROLE_TRIANGLE});
        name_place(panel, at[i], name[i], side[i]);
    }
}

static void draw_path(fig_panel *panel, const witness *w)
{
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector from = fig_vector_of(w->place[0]), to = fig_vector_of(w->end);
    fig_scene_dashes(scene, from, to, FIG_WIDTH_LINE, 3,
                     (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_ball(scene, from, FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_ball(scene, to, FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    name_place(panel, from, "$v$", FIG_SIDE_E);
    name_place(panel, to, "$v'$", FIG_SIDE_W);
}

/// Where something meets what moves.
static void mark(fig_scene *scene, double x, double y, double z)
{
    fig_scene_ball(scene, (tf_vector){{x, y, z}}, FIG_WIDTH_MARK,
                   (fig_paint){.role = FIG_ROLE_CONTACT});
}

/// A move: the surface before it, as its edges, and after it.
static void draw_move(fig_panel *panel, const witness *w)
{
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    for (int i = 0; i < w->vertices; i++)
        at[i] = fig_vector_of(w->place[i]);
    for (int i = 1; i < 4; i++)
        fig_scene_dashes(scene, at[0], at[i], FIG_WIDTH_THIN, 3,
                         (fig_paint){.role = FIG_ROLE_INK});
    draw_path(panel, w);
    at[0] = fig_vector_of(w->end);
    fig_patch_triangles(scene, at, 4, w->triangle, green);
    if (w->refusal == TF_PASSED_VERTEX)
        fig_patch_triangles(scene, at, 4, w->triangle + 4, red);
    else if (w->refusal == TF_PASSED_EDGE)
        mark(scene, 0, 0, -1);
    else
        mark(scene, -1.0 / 3, -1.0 / 3, -1.0 / 3);
}

static fig_box box_of(int i)
{
    double width = FIG_PAGE_WIDTH / (i < 2 ? 2 : 3);
    return (fig_box){width * (i < 2 ? i : i - 2) + 4, i < 2 ? 4 : 112,
                     width - 8, i < 2 ? 100 : 134};
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < WITNESSES; i++) {
        const witness *w = &witnesses[i];
        fig_box box = box_of(i);
        fig_panel *panel = fig_page_panel(page, box);
        fig_panel_look(panel, (fig_camera){.azimuth = w->flips ? 0 : 64,
                                           .elevation = w->flips ? 90 : 22});
        fig_panel_margin(panel, 15);
        if (w->flips)
            draw_flip(panel, w);
        else
            draw_move(panel, w);
        fig_page_text(page, box.x + 10, box.y + 14, FIG_ALIGN_CENTER, w->title,
                      FIG_LETTERS_TITLE, FIG_ROLE_INK);
        print_numbers(numbers, w);
    }
}

const fig_figure fig_five_tests = {
    .name = "five-tests",
    .title = "For each of the five tests a surgery that only it refuses",
    .width = FIG_PAGE_WIDTH,
    .height = 250,
    .draw = draw,
};
