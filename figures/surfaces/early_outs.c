// How often an early out could leave: the share of vectors all of whose queries
// are separated by an axis, by the number of their lanes.
#include "kit/figures.h"

#include "base/require.h"
#include "fast/block_filter.h"
#include "kit/random.h"
#include "renderer/plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    RANDOM_QUERIES = 32768,
    WIDTHS = 7 ///< 1, 2, 4, ..., 64 lanes
};

/// Queries whose separated ones are a bit each.
typedef struct batch {
    int kind; ///< 0: a point and a triangle, 1: two edges
    size_t count;
    tf_query_block *block;
    tf_query_masks *masks;
} batch;

static batch batch_new(int kind, size_t most)
{
    batch b = {
        .kind = kind,
        .block = calloc(most / TF_BLOCK_QUERIES + 1, sizeof(tf_query_block)),
        .masks = calloc(most / TF_MASK_QUERIES + 1, sizeof(tf_query_masks))};
    TF_REQUIRE(b.block && b.masks);
    return b;
}

static void batch_free(batch *b)
{
    free(b->block);
    free(b->masks);
}

/// Sets a vertex of the last query.
static void set_vertex(batch *b, int vertex, const double start[TF_AXES],
                       const double end[TF_AXES])
{
    tf_query_block *block = &b->block[b->count / TF_BLOCK_QUERIES];
    for (int k = 0; k < TF_AXES; k++) {
        block->at[0][vertex][k][b->count % TF_BLOCK_QUERIES] = start[k];
        block->at[1][vertex][k][b->count % TF_BLOCK_QUERIES] = end[k];
    }
}

static void filter(batch *b)
{
    tf_status status =
        b->kind == 0 ? tf_filter_point_triangle(b->count, b->block, b->masks)
                     : tf_filter_edge_edge(b->count, b->block, b->masks);
    TF_REQUIRE(status == TF_OK);
}

/// The share of vectors of some lanes all of whose queries are separated.
static double share_of(const batch *b, size_t lanes)
{
    size_t vectors = b->count / lanes, all = 0;
    for (size_t i = 0; i < vectors; i++) {
        bool separated = true;
        for (size_t j = i * lanes; j < (i + 1) * lanes; j++)
            separated &=
                b->masks[j / TF_MASK_QUERIES].separated >> j % TF_MASK_QUERIES &
                1;
        all += separated;
    }
    return (double)all / (double)vectors;
}

// The queries ------------------------------------------------------------

/// At random in cubes of that size in the unit cube.
static batch random_batch(int kind, double size)
{
    batch b = batch_new(kind, RANDOM_QUERIES);
    uint64_t random = 15;
    for (; b.count < RANDOM_QUERIES; b.count++) {
        double corner[TF_AXES];
        for (int k = 0; k < TF_AXES; k++)
            corner[k] = (1 - size) * fig_random_number(&random);
        for (int v = 0; v < 4; v++) {
            double start[TF_AXES], end[TF_AXES];
            for (int k = 0; k < TF_AXES; k++) {
                start[k] = corner[k] + size * fig_random_number(&random);
                end[k] = start[k] + 0.2 * fig_random_number(&random) - 0.1;
            }
            set_vertex(&b, v, start, end);
        }
    }
    filter(&b);
    return b;
}

static batch soup(int kind)
{
    return random_batch(kind, 1);
}

static batch near(int kind)
{
    return random_batch(kind, 0.1);
}

// The picture ------------------------------------------------------------

static const struct scene {
    const char *key, *name;
    batch (*make)(int kind);
    fig_role role;
} scenes[] = {
    {"soup", "soup", soup, FIG_ROLE_EDGE},
    {"near", "near", near, FIG_ROLE_OTHER_EDGE},
};

enum {
    SCENES = sizeof scenes / sizeof *scenes
};

static const char *const kind_key[] = {"pt", "ee"};
static const char *const kind_title[] = {"*a point and a triangle*",
                                         "*two edges*"};

/// The scene's curve, and as dashes what it would be if queries were in a
/// random order.
static void draw_scene(fig_page *page, const fig_plot *plot, int kind,
                       const struct scene *scene, FILE *numbers)
{
    batch b = scene->make(kind);
    fig_point at[WIDTHS], mixed[WIDTHS];
    for (int i = 0; i < WIDTHS; i++) {
        double lanes = ldexp(1, i);
        at[i] = (fig_point){lanes, 100 * share_of(&b, (size_t)lanes)};
        mixed[i] = (fig_point){lanes, 100 * pow(at[0].y / 100, lanes)};
        char key[48];
        snprintf(key, sizeof key, "%s_%s_%.0f", kind_key[kind], scene->key,
                 lanes);
        fig_number(numbers, key, at[i].y);
        snprintf(key, sizeof key, "%s_%s_mixed_%.0f", kind_key[kind],
                 scene->key, lanes);
        fig_number(numbers, key, mixed[i].y);
    }
    char key[48];
    snprintf(key, sizeof key, "%s_%s_queries", kind_key[kind], scene->key);
    fig_number(numbers, key, (double)b.count);
    fig_stroke stroke = {.paint.role = scene->role, .width = FIG_WIDTH_LINE};
    fig_plot_curve(page, plot, WIDTHS, at, stroke);
    for (int i = 0; i < WIDTHS; i++)
        fig_plot_dot(page, plot, at[i].x, at[i].y, 4.6, scene->role);
    stroke.dash = 3;
    stroke.width = FIG_WIDTH_THIN;
    fig_plot_curve(page, plot, WIDTHS, mixed, stroke);
    batch_free(&b);
}

/// Ticks at the numbers of lanes.
static void draw_scale(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < WIDTHS; i++) {
        char name[16];
        snprintf(name, sizeof name, "%d", 1 << i);
        fig_plot_tick(page, fig_plot_place(plot, 1 << i, 0), name);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double side = fig_page_width(page) / 2;
    for (int kind = 0; kind < 2; kind++) {
        fig_plot plot = {.box = {kind * side + 36, 34, side - 46, 130},
                         .x = {1, 64},
                         .y = {0, 100},
                         .log_x = true,
                         .name_x = "lanes",
                         .name_y = kind == 0 ? "% of vectors" : NULL,
                         .ticks_x = -1};
        fig_plot_frame(page, &plot);
        draw_scale(page, &plot);
        for (int i = 0; i < SCENES; i++)
            draw_scene(page, &plot, kind, &scenes[i], numbers);
        fig_page_text(page, plot.box.x + plot.box.width / 2, plot.box.y - 6,
                      FIG_ALIGN_CENTER, kind_title[kind], FIG_LETTERS,
                      FIG_ROLE_INK);
    }
    static const double place[SCENES] = {40, 104};
    for (int i = 0; i < SCENES; i++)
        fig_plot_key(page, place[i], 14, scenes[i].name, scenes[i].role);
}

const fig_figure fig_early_outs = {
    .name = "early-outs",
    .title = "How many vectors of queries are separated in all lanes",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .draw = draw,
};
