// A curve of many moving edges in the boxes of its leaves, and the search for
// those that one leaf's edges may meet.
#include "kit/figures.h"

#include "base/require.h"
#include "renderer/plot.h"
#include "surface/join.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

enum {
    EDGES = 1600,
    CHOSEN = 37 ///< the leaf whose search is shown
};

static const double pi = 3.141592653589793;
static const double panel_side = 180, gap = 16, panel_top = 4;

static const fig_paint leaf_paint = {.role = FIG_ROLE_EDGE, .opacity = 0.16},
                       outline = {.role = FIG_ROLE_EDGE, .opacity = 0.55},
                       chosen_paint = {.role = FIG_ROLE_CONTACT,
                                       .opacity = 0.6},
                       near_paint = {.role = FIG_ROLE_OTHER_EDGE,
                                     .opacity = 0.55},
                       idle_outline = {.role = FIG_ROLE_NEUTRAL,
                                       .opacity = 0.9};

/// A closed curve that crosses itself often, with its tree.
typedef struct scenery {
    tf_path vertex[EDGES];
    tf_box whole;
    int corner[2 * EDGES];
    tf_tree tree;
} scenery;

// The tree ---------------------------------------------------------------

static void curve_at(double s, double x[2])
{
    x[0] = sin(3 * s);
    x[1] = sin(4 * s + 0.4);
}

/// Each vertex moves along the curve by the length of an edge.
static void make_curve(scenery *s)
{
    s->whole = (tf_box){{0}, {0}};
    for (int i = 0; i < EDGES; i++) {
        double x[2][2];
        tf_path path = {{0}};
        for (int end = 0; end < 2; end++) {
            curve_at(2 * pi * (i + end) / EDGES, x[end]);
            for (int k = 0; k < 2; k++) {
                int side = TF_AXES * end + k;
                path.at[side] = (float)x[end][k];
                s->whole.low[side] = fminf(s->whole.low[side], path.at[side]);
                s->whole.high[side] = fmaxf(s->whole.high[side], path.at[side]);
            }
        }
        s->vertex[i] = path;
        s->corner[(ptrdiff_t)2 * i] = i;
        s->corner[2 * i + 1] = (i + 1) % EDGES;
    }
}

static scenery *make_scenery(void)
{
    scenery *s = calloc(1, sizeof *s);
    TF_REQUIRE(s);
    make_curve(s);
    tf_tree_elements elements = {.count = EDGES,
                                 .corners = 2,
                                 .corner = s->corner,
                                 .vertex = s->vertex,
                                 .whole = &s->whole,
                                 .swept = true};
    tf_tree_workspace workspace = {0};
    TF_REQUIRE(tf_tree_build(&s->tree, &elements, &workspace, NULL));
    tf_tree_workspace_free(&workspace);
    return s;
}

/// A sink that counts.
typedef struct counter {
    tf_pair_sink sink; ///< first, so that a sink is its counter
    long count;
} counter;

static bool take(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    (void)pair;
    ((counter *)sink)->count += count;
    return true;
}

static long count_candidates(const scenery *s)
{
    counter *all = calloc(1, sizeof *all);
    TF_REQUIRE(all);
    all->sink.take = take;
    tf_tree_join(&s->tree, &s->tree, (tf_range){0, s->tree.packs[0]},
                 &all->sink);
    long count = all->count;
    free(all);
    return count;
}

// Boxes ------------------------------------------------------------------

/// Whether swept boxes do.
static bool overlap(const tf_box *a, const tf_box *b)
{
    for (int k = TF_AXES; k < TF_SIDES; k++)
        if (a->low[k] > b->high[k] || b->low[k] > a->high[k])
            return false;
    return true;
}

static tf_box box_of_pack(const scenery *s, int level, int pack)
{
    return tf_pack_union(&s->tree.level[level][pack]);
}

static fig_plot plot_of(int panel)
{
    double margin = (FIG_PAGE_WIDTH - 2 * panel_side - gap) / 2;
    return (fig_plot){.box = {margin + panel * (panel_side + gap), panel_top,
                              panel_side, panel_side},
                      .x = {-1.03, 1.03},
                      .y = {-1.03, 1.03}};
}

static void draw_box(fig_page *page, const fig_plot *plot, const tf_box *box,
                     const fig_paint *fill, fig_paint line, double width)
{
    const float *least = box->low + TF_AXES, *most = box->high + TF_AXES;
    fig_point low = fig_plot_place(plot, least[0], least[1]);
    fig_point high = fig_plot_place(plot, most[0], most[1]);
    const fig_point corner[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    if (fill)
        fig_page_fill(page, 4, corner, *fill);
    fig_page_line(page, 4, corner,
                  (fig_stroke){.paint = line, .width = width, .closed = true});
}

static void draw_curve(fig_page *page, const fig_plot *plot)
{
    static fig_point at[EDGES];
    for (int i = 0; i < EDGES; i++) {
        double x[2];
        curve_at(2 * pi * i / EDGES, x);
        at[i] = fig_plot_place(plot, x[0], x[1]);
    }
    fig_page_line(page, EDGES, at,
                  (fig_stroke){.width = FIG_WIDTH_THIN, .closed = true});
}

static void draw_leaves(fig_page *page, const scenery *s)
{
    fig_plot plot = plot_of(0);
    for (int leaf = 0; leaf < s->tree.packs[0]; leaf++) {
        tf_box box = box_of_pack(s, 0, leaf);
        draw_box(page, &plot, &box, &leaf_paint, outline, FIG_WIDTH_HAIR);
    }
    draw_curve(page, &plot);
}

/// The packs of the second level; those near the chosen leaf are opened, and
/// their leaves that overlap it are filled.
static void draw_search(fig_page *page, const scenery *s, FILE *numbers)
{
    fig_plot plot = plot_of(1);
    tf_box chosen = box_of_pack(s, 0, CHOSEN);
    int opened = 0, near = 0;
    for (int pack = 0; pack < s->tree.packs[1]; pack++) {
        tf_box box = box_of_pack(s, 1, pack);
        bool open = overlap(&box, &chosen);
        opened += open;
        draw_box(page, &plot, &box, NULL, open ? near_paint : idle_outline,
                 open ? FIG_WIDTH_LINE : FIG_WIDTH_HAIR);
        int first = TF_LANES * pack, leaves = s->tree.packs[0];
        for (int i = first; open && i < first + TF_LANES && i < leaves; i++) {
            tf_box leaf = box_of_pack(s, 0, i);
            if (!overlap(&leaf, &chosen))
                continue;
            near++;
            draw_box(page, &plot, &leaf, &near_paint, near_paint,
                     FIG_WIDTH_HAIR);
        }
    }
    draw_box(page, &plot, &chosen, &chosen_paint, chosen_paint, FIG_WIDTH_THIN);
    draw_curve(page, &plot);
    fig_number(numbers, "opened", opened);
    fig_number(numbers, "near", near);
}

static void draw(fig_page *page, FILE *numbers)
{
    scenery *s = make_scenery();
    int leaves = s->tree.packs[0];
    draw_leaves(page, s);
    draw_search(page, s, numbers);
    fig_number(numbers, "edges", EDGES);
    fig_number(numbers, "leaves", leaves);
    fig_number(numbers, "packs", s->tree.packs[1]);
    fig_number(numbers, "levels", s->tree.levels);
    fig_number(numbers, "pairs", EDGES * (EDGES - 1) / 2.0);
    fig_number(numbers, "candidates", (double)count_candidates(s));
    tf_tree_free(&s->tree);
    free(s);
}

const fig_figure fig_box_tree = {
    .name = "box-tree",
    .title = "The boxes of a tree, and the search for one leaf",
    .width = FIG_PAGE_WIDTH,
    .height = 200,
    .draw = draw,
};
