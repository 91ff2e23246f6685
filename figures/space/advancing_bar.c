// A bar that turns about one end towards a point, and the steps by which
// conservative advancement comes closer.
#include "kit/figures.h"

#include "base/require.h"
#include "kit/film.h"
#include "linear/rigid_motion.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    STEPS_MOST = 64,
    ARC = 65
};

static const double pi = 3.14159265358979323846;
static const double turn = 90, start = 60; ///< degrees
static const double radius = 0.5;          ///< of the point, in bars
static const double threshold = 0.02;

/// The bar turns by `turn` degrees; the point rests `start` degrees ahead.
typedef struct scene {
    double bar_vertices[4], point_vertex[2];
    tf_rigid_body bar, point;
} scene;

static void make_scene(scene *s)
{
    *s = (scene){.bar_vertices = {0, 0, 1, 0},
                 .point_vertex = {radius * cos(start * pi / 180),
                                  radius * sin(start * pi / 180)}};
    s->bar = (tf_rigid_body){.vertices = s->bar_vertices,
                             .rotation = {0, 0, turn * pi / 180}};
    s->point =
        (tf_rigid_body){.vertices = s->point_vertex,
                        .center = {s->point_vertex[0], s->point_vertex[1], 0}};
}

/// Where advancement is after at most some steps.
static tf_advancement advance(const scene *s, int steps)
{
    const tf_advance_limits limits = {.threshold = threshold, .steps = steps};
    tf_advancement found;
    tf_status status =
        tf_advance_point_edge(&limits, &s->point, &s->bar, &found);
    TF_REQUIRE(status == TF_OK);
    return found;
}

/// The times and distances of all steps, the start before them; returns how
/// many steps there are.
static int find_steps(const scene *s, tf_advancement at[STEPS_MOST + 1])
{
    at[0] = (tf_advancement){.distance = radius * sin(start * pi / 180)};
    int count = 0;
    do {
        count++;
        at[count] = advance(s, count);
    } while (count < STEPS_MOST && at[count].verdict == TF_UNDECIDED);
    return count;
}

static void draw_bar(fig_page *page, const fig_plot *plot, const scene *s,
                     double t, fig_stroke stroke)
{
    double tip[2];
    tf_rigid_position(2, &s->bar, 1, t, tip);
    const fig_point at[2] = {fig_plot_place(plot, 0, 0),
                             fig_plot_place(plot, tip[0], tip[1])};
    fig_page_line(page, 2, at, stroke);
}

/// The distance of bar and point at a step; as a circle around the point.
static void draw_circle(fig_page *page, const fig_plot *plot, const scene *s,
                        double distance, bool last)
{
    fig_point at = fig_plot_place(plot, s->point_vertex[0], s->point_vertex[1]);
    double scale = plot->box.width / (plot->x[1] - plot->x[0]);
    fig_page_arc(page, at.x, at.y, distance * scale, 0, 360,
                 (fig_stroke){.paint = {.role = FIG_ROLE_POINT,
                                        .opacity = last ? 0 : 0.55},
                              .width = last ? 1.4 : FIG_WIDTH_THIN,
                              .under_labels = true});
}

static void draw_arc(fig_page *page, const fig_plot *plot)
{
    fig_point at[ARC];
    for (int i = 0; i < ARC; i++) {
        double angle = turn * pi / 180 * i / (ARC - 1);
        at[i] = fig_plot_place(plot, cos(angle), sin(angle));
    }
    fig_page_line(page, ARC, at,
                  (fig_stroke){.paint.role = FIG_ROLE_NEUTRAL,
                               .width = FIG_WIDTH_THIN,
                               .dash = 3});
}

/// The bars and circles of the steps that have begun at a time, and the bar.
static void draw_steps(fig_page *page, const fig_plot *plot, const scene *s,
                       int count, const tf_advancement at[], double t)
{
    int begun = 0;
    while (begun < count && at[begun + 1].time <= t)
        begun++;
    for (int i = 0; i <= begun; i++) {
        draw_circle(page, plot, s, at[i].distance, i == begun);
        draw_bar(page, plot, s, at[i].time,
                 (fig_stroke){.paint = {.role = FIG_ROLE_EDGE, .opacity = 0.45},
                              .width = FIG_WIDTH_LINE});
    }
    draw_bar(page, plot, s, t,
             (fig_stroke){.paint.role = FIG_ROLE_EDGE, .width = 2.8});
    fig_plot_dot(page, plot, 0, 0, FIG_WIDTH_BALL, FIG_ROLE_EDGE);
    bool reached = t >= at[count].time;
    fig_point place = fig_plot_dot(page, plot, s->point_vertex[0],
                                   s->point_vertex[1], FIG_WIDTH_BALL,
                                   reached ? FIG_ROLE_CONTACT : FIG_ROLE_POINT);
    fig_page_text(page, place.x - 6, place.y - 6, FIG_ALIGN_RIGHT, "$p$",
                  FIG_LETTERS, FIG_ROLE_POINT);
}

/// A row of the table beside the picture for each step.
static void write_steps(fig_page *page, double x, double y, int count,
                        const tf_advancement at[], double t)
{
    static const char *const head[3] = {"step", "time", "distance"};
    static const double right[3] = {24, 76, 136};
    for (int c = 0; c < 3; c++)
        fig_page_text(page, x + right[c], y, FIG_ALIGN_RIGHT, head[c],
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int i = 0; i <= count; i++) {
        bool begun = at[i].time <= t;
        char text[3][32];
        snprintf(text[0], sizeof text[0], "%d", i);
        snprintf(text[1], sizeof text[1], "%.4f", at[i].time);
        snprintf(text[2], sizeof text[2], "%.4f", at[i].distance);
        for (int c = 0; c < 3 && begun; c++)
            fig_page_text(page, x + right[c], y + 14 * (i + 1), FIG_ALIGN_RIGHT,
                          text[c], FIG_LETTERS_SMALL,
                          i == count ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
    }
}

static void print_numbers(FILE *numbers, int count, const tf_advancement at[])
{
    fig_number(numbers, "threshold", threshold);
    fig_number(numbers, "steps", count);
    fig_number(numbers, "time", at[count].time);
    fig_number(numbers, "distance", at[count].distance);
    fig_number(numbers, "truth", start / turn);
    for (int i = 0; i <= 3; i++) {
        char key[32];
        snprintf(key, sizeof key, "time_%d", i);
        fig_number(numbers, key, at[i].time);
        snprintf(key, sizeof key, "distance_%d", i);
        fig_number(numbers, key, at[i].distance);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    scene s;
    tf_advancement at[STEPS_MOST + 1];
    make_scene(&s);
    int count = find_steps(&s, at);
    double height = fig_page_height(page);
    fig_box box = {4, 4, 216, height - 30};
    fig_plot plot = {.box = box, .x = {-0.22, 1.1}, .y = {-0.08, 0}};
    plot.y[1] = plot.y[0] + (plot.x[1] - plot.x[0]) * box.height / box.width;
    double still = at[count].time;
    double t = fig_film_time(page, numbers, still, still);
    draw_arc(page, &plot);
    draw_steps(page, &plot, &s, count, at, t);
    write_steps(page, 232, 30, count, at, t);
    if (fig_page_moves(page))
        fig_film_clock(page, 8, height - 10, FIG_PAGE_WIDTH - 16, t, still,
                       "threshold reached");
    print_numbers(numbers, count, at);
}

const fig_figure fig_advancing_bar = {
    .name = "advancing-bar",
    .title = "Conservative advancement of a bar that turns",
    .width = FIG_PAGE_WIDTH,
    .height = 236,
    .moves = true,
    .draw = draw,
};
