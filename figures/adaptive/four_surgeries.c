// A split, a move, a half-edge collapse and a flip: the patch that is removed,
// what is swept over, and the patch that is added.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/patches.h"

#include "surgery/collapse.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"

enum {
    SURGERIES = 4,
    PLACES = 8,
    MOST = 6,
    PATCHES = 2,
    ROWS = 3,
    SWEPT = 1 ///< the row between the patches
};

/// A place with its name, which is in the patches 1, 2 or, as 3, in both.
typedef struct named {
    tf_vector at;
    const char *name;
    int patches;
    fig_side side;
} named;

typedef struct patch {
    int count, triangle[MOST][3];
} patch;

typedef struct surgery {
    const char *title;
    int places;
    named place[PLACES];
    int corners, outline[MOST];
    patch patch[PATCHES];
    int sweeps, sweep[MOST][4];
} surgery;

static const surgery surgeries[SURGERIES] = {
    {.title = "split",
     .places = 5,
     .place = {{{{-1, 0, 0}}, "$a$", 3, FIG_SIDE_W},
               {{{1, 0, 0}}, "$b$", 3, FIG_SIDE_E},
               {{{0.1, 1, -0.1}}, "$c$", 3, FIG_SIDE_N},
               {{{-0.1, -1, -0.1}}, "$d$", 3, FIG_SIDE_S},
               {{{0.1, 0.05, 0.5}}, "$e$", 2, FIG_SIDE_N}},
     .corners = 4,
     .outline = {0, 3, 1, 2},
     .patch = {{2, {{0, 1, 2}, {1, 0, 3}}},
               {4, {{0, 4, 2}, {4, 1, 2}, {1, 4, 3}, {4, 0, 3}}}},
     .sweeps = 2,
     .sweep = {{0, 1, 2, 4}, {0, 1, 3, 4}}},
    {.title = "move",
     .places = 7,
     .place = {{{{-0.25, 0, 0.3}}, "$v$", 1, FIG_SIDE_N},
               {{{0.3, 0.1, 0.75}}, "$v'$", 2, FIG_SIDE_N},
               {{{1, 0.1, 0}}, "", 3, FIG_SIDE_E},
               {{{0.35, 0.95, 0.05}}, "", 3, FIG_SIDE_N},
               {{{-0.8, 0.7, 0}}, "", 3, FIG_SIDE_N},
               {{{-0.9, -0.5, 0}}, "$x$", 3, FIG_SIDE_W},
               {{{0.3, -0.95, 0}}, "$y$", 3, FIG_SIDE_S}},
     .corners = 5,
     .outline = {2, 3, 4, 5, 6},
     .patch = {{5, {{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 2}}},
               {5, {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {1, 6, 2}}}},
     .sweeps = 5,
     .sweep = {{0, 1, 2, 3},
               {0, 1, 3, 4},
               {0, 1, 4, 5},
               {0, 1, 5, 6},
               {0, 1, 6, 2}}},
    {.title = "half-edge collapse",
     .places = 6,
     .place = {{{{-0.15, 0, 0.45}}, "$s$", 1, FIG_SIDE_N},
               {{{1, 0.1, 0.1}}, "$d$", 3, FIG_SIDE_E},
               {{{0.35, 0.95, 0.05}}, "$c$", 3, FIG_SIDE_N},
               {{{-0.8, 0.7, 0}}, "", 3, FIG_SIDE_N},
               {{{-0.9, -0.5, 0}}, "", 3, FIG_SIDE_W},
               {{{0.3, -0.95, 0}}, "$c'$", 3, FIG_SIDE_S}},
     .corners = 5,
     .outline = {1, 2, 3, 4, 5},
     .patch = {{5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}}},
               {3, {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}}}},
     .sweeps = 3,
     .sweep = {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}}},
    {.title = "flip",
     .places = 4,
     .place = {{{{-1, 0, 0.4}}, "$a$", 3, FIG_SIDE_W},
               {{{1, 0, 0.4}}, "$b$", 3, FIG_SIDE_E},
               {{{0.1, 1, -0.1}}, "$c$", 3, FIG_SIDE_N},
               {{{-0.1, -1, -0.1}}, "$d$", 3, FIG_SIDE_S}},
     .corners = 4,
     .outline = {0, 3, 1, 2},
     .patch = {{2, {{0, 1, 2}, {1, 0, 3}}}, {2, {{2, 3, 1}, {3, 2, 0}}}},
     .sweeps = 1,
     .sweep = {{0, 1, 2, 3}}},
};

static const double row_height = 88;

/// The vertices; between the patches those of both.
static void draw_places(fig_panel *panel, const surgery *s, int row)
{
    fig_scene *scene = fig_panel_scene(panel);
    int shown = row == SWEPT ? 3 : row < SWEPT ? 1 : 2;
    for (int i = 0; i < s->places; i++) {
        const named *place = &s->place[i];
        fig_scene_reach(scene, place->at);
        if ((place->patches & shown) == 0)
            continue;
        fig_scene_ball(scene, place->at, 4,
                       (fig_paint){.role = FIG_ROLE_TRIANGLE});
        if (*place->name)
            fig_panel_label(panel, place->at,
                            (fig_label){.text = place->name,
                                        .size = FIG_LETTERS_SMALL,
                                        .side = place->side,
                                        .gap = 3});
    }
}

static void draw_row(fig_page *page, fig_box box, const surgery *s, int row)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = -18, .elevation = 38});
    fig_panel_margin(panel, 13);
    fig_scene *scene = fig_panel_scene(panel);
    tf_vector at[PLACES];
    for (int i = 0; i < s->places; i++)
        at[i] = s->place[i].at;
    draw_places(panel, s, row);
    if (row == SWEPT) {
        for (int i = 0; i < s->sweeps; i++)
            fig_patch_swept(scene, at, s->sweep[i]);
    } else {
        const patch *shown = &s->patch[row / 2];
        fig_patch_triangles(
            scene, at, shown->count, shown->triangle,
            (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.92});
    }
    fig_patch_outline(scene, at, s->corners, s->outline,
                      (fig_paint){.role = FIG_ROLE_TRIANGLE, .shade = 0.35});
}

/// What becomes of a surgery on a surface that is only the patch.
static tf_outcome try_surgery(int i)
{
    const surgery *s = &surgeries[i];
    double place[PLACES][3];
    for (int v = 0; v < s->places; v++)
        for (int k = 0; k < 3; k++)
            place[v][k] = s->place[v].at.x[k];
    const tf_mesh mesh = {.axes = 3,
                          .vertices = s->places,
                          .triangles = s->patch[0].count,
                          .triangle = s->patch[0].triangle[0]};
    tf_adaptive_surface *surface;
    tf_outcome outcome;
    int vertex;
    TF_REQUIRE(tf_adaptive_create(&mesh, place[0], &surface, NULL) == TF_OK);
    tf_status status =
        i == 0   ? tf_adaptive_split(surface, 0, 1, place[4], &vertex, &outcome)
        : i == 1 ? tf_adaptive_move(surface, 0, place[1], &outcome)
        : i == 2 ? tf_adaptive_collapse(surface, 0, 1, &outcome)
                 : tf_adaptive_flip(surface, 0, 1, &outcome);
    TF_REQUIRE(status == TF_OK);
    tf_adaptive_free(surface);
    return outcome;
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page) / SURGERIES;
    for (int i = 0; i < SURGERIES; i++) {
        const surgery *s = &surgeries[i];
        for (int row = 0; row < ROWS; row++) {
            fig_box box = {width * i, 16 + row_height * row, width, row_height};
            draw_row(page, box, s, row);
        }
        fig_page_text(page, width * (i + 0.5), 12, FIG_ALIGN_CENTER, s->title,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
    int done = 0;
    for (int i = 0; i < SURGERIES; i++)
        done += try_surgery(i) == TF_COMMITTED;
    fig_number(numbers, "done", done);
}

const fig_figure fig_four_surgeries = {
    .name = "four-surgeries",
    .title = "Four surgeries: the patches and what lies between them",
    .width = FIG_PAGE_WIDTH,
    .height = 284,
    .draw = draw,
};
