// How many candidates triangles at random have, by their size: few while they
// are small, all pairs when they are as large as the scene.
#include "kit/figures.h"

#include "base/require.h"
#include "kit/random.h"
#include "renderer/plot.h"
#include "surface/candidates.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    SCENES = 3,
    SIZES = 13,
    MOST = 1024
};

static const int counts[SCENES] = {64, 256, MOST};
static const fig_role roles[SCENES] = {FIG_ROLE_EDGE, FIG_ROLE_TRIANGLE,
                                       FIG_ROLE_CONTACT};

/// The side of the boxes of triangles: the scene's is 1.
static double size_of(int i)
{
    return pow(10, -1.5 + 0.125 * i);
}

/// Candidates of triangles of three corners each, which are at random in cubes
/// of a size that are at random in the unit cube.
static double candidates_of(int triangles, double size)
{
    static double x[9 * MOST];
    static int corner[3 * MOST];
    uint64_t random = 13;
    for (int i = 0; i < triangles; i++)
        for (int k = 0; k < 3; k++) {
            double low = (1 - size) * fig_random_number(&random);
            for (int c = 0; c < 3; c++)
                x[9 * i + 3 * c + k] = low + size * fig_random_number(&random);
        }
    for (int i = 0; i < 3 * triangles; i++)
        corner[i] = i;
    tf_mesh mesh = {.axes = 3,
                    .vertices = 3 * triangles,
                    .triangles = triangles,
                    .triangle = corner};
    tf_motion rest = {3, 3 * triangles, x, x};
    tf_surface *surface;
    tf_candidates found;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_candidates(surface, &rest, NULL, &found, NULL) ==
               TF_OK);
    size_t all = found.point_count + found.edge_count;
    tf_surface_free(surface);
    return (double)all;
}

/// Pairs of elements of different triangles: of n triangles 3 n points and n - 1
/// triangles each, and 3 n edges.
static double pairs_of(int triangles)
{
    double n = triangles;
    return 3 * n * (n - 1) + 9 * n * (n - 1) / 2;
}

static void draw_scene(fig_page *page, const fig_plot *plot, int scene,
                       FILE *numbers)
{
    fig_point at[SIZES];
    int shown = 0;
    double n = counts[scene];
    for (int i = 0; i < SIZES; i++) {
        double candidates = candidates_of(counts[scene], size_of(i));
        char key[32];
        snprintf(key, sizeof key, "%d_%d", counts[scene], i);
        fig_number(numbers, key, candidates);
        if (candidates / n >= plot->y[0])
            at[shown++] = (fig_point){size_of(i), candidates / n};
    }
    fig_plot_curve(
        page, plot, shown, at,
        (fig_stroke){.paint.role = roles[scene], .width = FIG_WIDTH_LINE});
    for (int i = 0; i < shown; i++)
        fig_plot_dot(page, plot, at[i].x, at[i].y, 4, roles[scene]);
    fig_point all[2] = {{plot->x[0], pairs_of(counts[scene]) / n},
                        {plot->x[1], pairs_of(counts[scene]) / n}};
    fig_plot_curve(page, plot, 2, all,
                   (fig_stroke){.paint.role = roles[scene],
                                .width = FIG_WIDTH_THIN,
                                .dash = 3});
}

/// What the dashed lines are.
static void draw_dash(fig_page *page, double x, double y)
{
    fig_point dash[2] = {{x, y - 3}, {x + 10, y - 3}};
    fig_page_line(page, 2, dash,
                  (fig_stroke){.width = FIG_WIDTH_THIN, .dash = 3});
    fig_page_text(page, x + 13, y, FIG_ALIGN_LEFT, "all pairs",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {48, 8, fig_page_width(page) - 156, 158},
                     .x = {0.03, 1.05},
                     .y = {0.01, 10000},
                     .log_x = true,
                     .log_y = true,
                     .name_x = "size of a triangle",
                     .name_y = "candidates per triangle"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < SCENES; i++) {
        char text[32];
        draw_scene(page, &plot, i, numbers);
        snprintf(text, sizeof text, "%d triangles", counts[SCENES - 1 - i]);
        fig_plot_key(page, plot.box.x + plot.box.width + 14, 30 + 16 * i, text,
                     roles[SCENES - 1 - i]);
        snprintf(text, sizeof text, "%d_pairs", counts[i]);
        fig_number(numbers, text, pairs_of(counts[i]));
    }
    draw_dash(page, plot.box.x + plot.box.width + 14, 30 + 16 * SCENES);
}

const fig_figure fig_candidate_counts = {
    .name = "candidate-counts",
    .title = "Candidates of random triangles, by their size",
    .width = FIG_PAGE_WIDTH,
    .height = 200,
    .draw = draw,
};
