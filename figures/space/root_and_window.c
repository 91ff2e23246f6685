// The quadratic of a point and an edge over time, and their distance: for a
// point that hits the edge, and for one that passes beyond its end.
#include "kit/figures.h"

#include "base/require.h"
#include "linear/quadratic.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    SCENES = 2,
    VERTICES = 3,
    CURVE = 401
};

/// The point and the two ends of the edge, at t = 0 and at t = 1.
static const struct scene {
    const char *key, *title;
    double start[VERTICES][2], end[VERTICES][2];
} scenes[SCENES] = {
    {"hit",
     "*the point hits the edge*",
     {{1, 3}, {0, 0}, {4, 0}},
     {{2, 0}, {0, 1}, {4, 2}}},
    {"miss",
     "*the point passes beyond its end*",
     {{3.75, 3}, {0, 0}, {4, 0}},
     {{4.75, 0}, {0, 1}, {4, 2}}},
};

static const double tolerance = 0.5;

static void find_places(const struct scene *s, double t, double x[VERTICES][2])
{
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < 2; k++)
            x[i][k] = (1 - t) * s->start[i][k] + t * s->end[i][k];
}

/// The determinant of the edge and the way from its first end to the point.
static double turn(const struct scene *s, double t)
{
    double x[VERTICES][2];
    find_places(s, t, x);
    return (x[2][0] - x[1][0]) * (x[0][1] - x[1][1]) -
           (x[2][1] - x[1][1]) * (x[0][0] - x[1][0]);
}

static double distance(const struct scene *s, double t)
{
    double x[VERTICES][2], edge[2], to[2], along = 0, square = 0;
    find_places(s, t, x);
    for (int k = 0; k < 2; k++) {
        edge[k] = x[2][k] - x[1][k];
        to[k] = x[0][k] - x[1][k];
        along += edge[k] * to[k];
        square += edge[k] * edge[k];
    }
    double part = fmin(fmax(along / square, 0), 1);
    return hypot(to[0] - part * edge[0], to[1] - part * edge[1]);
}

static tf_contact query(const struct scene *s, tf_tolerances tolerances)
{
    const tf_motion motion = {2, VERTICES, s->start[0], s->end[0]};
    tf_contact contact;
    tf_status status = tf_quadratic_point_edge(&tolerances, &motion, 0,
                                               (const int[]){1, 2}, &contact);
    TF_REQUIRE(status == TF_OK);
    return contact;
}

/// The time between two at which the distance is the tolerance.
static double border(const struct scene *s, double inside, double outside)
{
    for (int i = 0; i < 60; i++) {
        double middle = (inside + outside) / 2;
        *(distance(s, middle) <= tolerance ? &inside : &outside) = middle;
    }
    return inside;
}

static void draw_graph(fig_page *page, const fig_plot *plot,
                       const struct scene *s,
                       double (*value)(const struct scene *, double),
                       fig_role role)
{
    fig_point at[CURVE];
    for (int i = 0; i < CURVE; i++) {
        double t = (double)i / (CURVE - 1);
        at[i] = (fig_point){t, value(s, t)};
    }
    fig_plot_curve(page, plot, CURVE, at,
                   (fig_stroke){.paint.role = role, .width = 1.5});
}

/// A band over an interval of time, the height of the plot.
static void draw_window(fig_page *page, const fig_plot *plot,
                        const double window[2])
{
    fig_point low = fig_plot_place(plot, window[0], plot->y[0]);
    fig_point high = fig_plot_place(plot, window[1], plot->y[1]);
    fig_page_fill_box(page,
                      (fig_box){low.x, high.y, high.x - low.x, low.y - high.y},
                      (fig_paint){.role = FIG_ROLE_CONTACT, .opacity = 0.16});
}

static void draw_scene(fig_page *page, const struct scene *s, double left,
                       FILE *numbers)
{
    fig_plot above = {.box = {left + 36, 20, 148, 82},
                      .x = {0, 1},
                      .y = {-9, 14},
                      .name_y = "$f(t)$",
                      .ticks_x = -1};
    fig_plot below = {.box = {left + 36, 118, 148, 82},
                      .x = {0, 1},
                      .y = {0, 3},
                      .name_x = "$t$",
                      .name_y = "distance"};
    // With this tolerance a root counts wherever it is on the line of the edge.
    double root = query(s, (tf_tolerances){.barycentric = 10}).toi_lo;
    const double window[2] = {border(s, root, 0), border(s, root, 1)};
    draw_window(page, &above, window);
    draw_window(page, &below, window);
    fig_plot_frame(page, &above);
    fig_plot_frame(page, &below);
    fig_plot_level(page, &above, 0);
    fig_plot_curve(page, &below, 2,
                   (fig_point[]){{0, tolerance}, {1, tolerance}},
                   (fig_stroke){.paint.role = FIG_ROLE_CONTACT,
                                .width = FIG_WIDTH_THIN,
                                .dash = 3});
    draw_graph(page, &above, s, turn, FIG_ROLE_EDGE);
    draw_graph(page, &below, s, distance, FIG_ROLE_POINT);
    fig_plot_dot(page, &above, root, 0, FIG_WIDTH_BALL, FIG_ROLE_CONTACT);
    fig_plot_dot(page, &below, root, distance(s, root), FIG_WIDTH_BALL,
                 FIG_ROLE_CONTACT);
    fig_page_title(page, above.box, s->title);

    char key[32];
    const struct {
        const char *name;
        double value;
    } print[] = {{"root", root},
                 {"distance", distance(s, root)},
                 {"from", window[0]},
                 {"to", window[1]},
                 {"exact", query(s, (tf_tolerances){0}).verdict == TF_HIT},
                 {"tolerant",
                  query(s, (tf_tolerances){tolerance, 0}).verdict == TF_HIT}};
    for (size_t i = 0; i < sizeof print / sizeof *print; i++) {
        snprintf(key, sizeof key, "%s_%s", s->key, print[i].name);
        fig_number(numbers, key, print[i].value);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < SCENES; i++)
        draw_scene(page, &scenes[i], fig_page_width(page) / SCENES * i,
                   numbers);
    fig_number(numbers, "tolerance", tolerance);
    fig_number(numbers, "shift", scenes[1].start[0][0] - scenes[0].start[0][0]);
}

const fig_figure fig_root_and_window = {
    .name = "root-and-window",
    .title = "A quadratic, its root, and the times within a tolerance",
    .width = FIG_PAGE_WIDTH,
    .height = 236,
    .draw = draw,
};
