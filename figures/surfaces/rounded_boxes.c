// Intervals of one axis before and after rounding to float: the lines that join
// a number with its float never cross.
#include "kit/figures.h"

#include "base/require.h"
#include "renderer/plot.h"
#include "surface/box.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

enum {
    PAIRS = 3,
    ENDS = 4 ///< of a pair of intervals
};

/// The spacing of floats between 1/2 and 1.
static const double unit = 0x1p-24;

/// The ends of a pair, in units from 3/4: of the first interval, then of the
/// second.
static const struct pair {
    const char *key, *title;
    double end[ENDS];
} pairs[PAIRS] = {
    {"overlap", "*overlap by 0.2 units*", {0.65, 2.7, 2.5, 3.75}},
    {"close", "*0.2 units apart*", {0.65, 2.1, 2.3, 3.75}},
    {"apart", "*1.1 units apart*", {0.65, 1.7, 2.8, 3.75}},
};

/// The same after rounding, in units, as the paths of vertices have them.
static void round_ends(const double end[ENDS], double rounded[ENDS])
{
    // The first two vertices make the frame that from -1 to 1.
    double start[3 * (ENDS / 2 + 2)] = {-1, 0, 0, 1};
    double stop[3 * (ENDS / 2 + 2)] = {-1, 0, 0, 1};
    tf_motion motion = {3, ENDS / 2 + 2, start, stop};
    for (int i = 0; i < ENDS / 2; i++) {
        start[(ptrdiff_t)3 * (i + 2)] =
            (0.75 + unit * end[(ptrdiff_t)2 * i]) / 2;
        stop[(ptrdiff_t)3 * (i + 2)] =
            (0.75 + unit * end[(ptrdiff_t)2 * i + 1]) / 2;
    }
    tf_frame frame;
    tf_path path[ENDS / 2 + 2];
    int bad;
    TF_REQUIRE(tf_frame_of(3, &motion, NULL, &frame, &bad) == TF_OK);
    tf_frame_sweep(&frame);
    // The scale brings 1 to 1/2 or 1; here the ends shall be near 3/4.
    double back = 0.75 / (frame.scale * 0.375);
    tf_vertex_paths(&frame, &motion, NULL, path);
    for (int i = 0; i < ENDS; i++) {
        double at = (double)path[i / 2 + 2].at[i % 2 ? TF_AXES : 0];
        rounded[i] = (back * at - 0.75) / unit;
    }
}

static fig_plot plot_of(int pair)
{
    double side = FIG_PAGE_WIDTH / PAIRS;
    return (fig_plot){.box = {pair * side + 8, 10, side - 16, 92},
                      .x = {-0.25, 4.65},
                      .y = {0, 1}};
}

static void draw_ruler(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i <= 4; i++) {
        fig_point tick[2] = {fig_plot_place(plot, i, 0.02),
                             fig_plot_place(plot, i, 0.98)};
        fig_page_line(
            page, 2, tick,
            (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL, .opacity = 0.6},
                         .width = FIG_WIDTH_HAIR});
    }
}

static void draw_interval(fig_page *page, const fig_plot *plot,
                          const double end[2], double height, fig_role role)
{
    fig_point at[2] = {fig_plot_place(plot, end[0], height),
                       fig_plot_place(plot, end[1], height)};
    fig_page_line(page, 2, at,
                  (fig_stroke){.paint.role = role, .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < 2; i++)
        fig_page_dot(page, at[i].x, at[i].y, 5, (fig_paint){.role = role});
}

static void draw_pair(fig_page *page, int number, FILE *numbers)
{
    static const fig_role role[2] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
    static const double above[2] = {0.88, 0.74}, below[2] = {0.3, 0.16};
    const struct pair *pair = &pairs[number];
    fig_plot plot = plot_of(number);
    double rounded[ENDS];
    round_ends(pair->end, rounded);
    draw_ruler(page, &plot);
    for (int i = 0; i < ENDS; i++) {
        fig_point way[2] = {fig_plot_place(&plot, pair->end[i], above[i / 2]),
                            fig_plot_place(&plot, rounded[i], below[i / 2])};
        fig_page_line(
            page, 2, way,
            (fig_stroke){.paint = {.role = role[i / 2], .opacity = 0.6},
                         .width = FIG_WIDTH_HAIR,
                         .dash = 2});
    }
    for (int i = 0; i < 2; i++) {
        draw_interval(page, &plot, pair->end + (ptrdiff_t)2 * i, above[i],
                      role[i]);
        draw_interval(page, &plot, rounded + (ptrdiff_t)2 * i, below[i],
                      role[i]);
    }
    fig_page_caption(page, plot.box, pair->title);
    char key[32];
    snprintf(key, sizeof key, "%s_before", pair->key);
    fig_number(numbers, key, pair->end[1] - pair->end[2]);
    snprintf(key, sizeof key, "%s_after", pair->key);
    fig_number(numbers, key, rounded[1] - rounded[2]);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < PAIRS; i++)
        draw_pair(page, i, numbers);
}

const fig_figure fig_rounded_boxes = {
    .name = "rounded-boxes",
    .title = "Two intervals before and after rounding to float",
    .width = FIG_PAGE_WIDTH,
    .height = 124,
    .draw = draw,
};
