// Steps and error of conservative advancement over the threshold, for points at
// three distances from the pivot of a turning bar, beside the closed forms.
#include "kit/figures.h"

#include "base/require.h"
#include "linear/rigid_motion.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    POINTS = 3,
    THRESHOLDS = 11 ///< 1e-2 to 1e-12
};

static const double pi = 3.14159265358979323846;
static const double turn = 90, start = 60; ///< degrees

static const struct rest {
    double radius; ///< of the point, in lengths of the bar
    const char *name;
    fig_role role;
} rests[POINTS] = {{0.1, "$r = 0.1$", FIG_ROLE_CONTACT},
                   {0.5, "$r = 0.5$", FIG_ROLE_EDGE},
                   {0.9, "$r = 0.9$", FIG_ROLE_TRIANGLE}};

static tf_advancement advance(double radius, double threshold)
{
    const double bar_vertices[4] = {0, 0, 1, 0};
    const double point_vertex[2] = {radius * cos(start * pi / 180),
                                    radius * sin(start * pi / 180)};
    const tf_rigid_body bar = {.vertices = bar_vertices,
                               .rotation = {0, 0, turn * pi / 180}};
    const tf_rigid_body point = {.vertices = point_vertex,
                                 .center = {point_vertex[0], point_vertex[1]}};
    const tf_advance_limits limits = {.threshold = threshold};
    tf_advancement found;
    tf_status status = tf_advance_point_edge(&limits, &point, &bar, &found);
    TF_REQUIRE(status == TF_OK && found.verdict == TF_HIT);
    return found;
}

/// The closed form, to first order: in each step all but half a threshold of
/// the distance shrinks to 1 - r of itself.
static double predicted_steps(double radius, double threshold)
{
    double spare = threshold / 2, distance = radius * start * pi / 180;
    return log(spare / (distance - spare)) / log(1 - radius);
}

/// The time from the threshold to the contact: an angle of asin(d / r).
static double error_at(double radius, double distance)
{
    return asin(distance / radius) / (turn * pi / 180);
}

/// One of the two plots: the values of a point over the threshold.
static void draw_values(fig_page *page, const fig_plot *plot,
                        const struct rest *rest, const double value[],
                        const double predicted[])
{
    fig_point at[THRESHOLDS];
    for (int i = 0; i < THRESHOLDS; i++) {
        at[i] = (fig_point){pow(10, -2 - i), predicted[i]};
        if (value[i] >= plot->y[0] && value[i] <= plot->y[1])
            fig_plot_dot(page, plot, at[i].x, value[i], 4.6, rest->role);
    }
    fig_plot_curve(page, plot, THRESHOLDS, at,
                   (fig_stroke){.paint.role = rest->role,
                                .width = FIG_WIDTH_THIN,
                                .dash = 2.5});
}

static void draw_point(fig_page *page, const fig_plot plot[2],
                       const struct rest *rest, FILE *numbers)
{
    double steps[THRESHOLDS], error[THRESHOLDS];
    double predicted[THRESHOLDS], bound[THRESHOLDS];
    for (int i = 0; i < THRESHOLDS; i++) {
        double threshold = pow(10, -2 - i);
        tf_advancement found = advance(rest->radius, threshold);
        steps[i] = found.steps;
        error[i] = start / turn - found.time;
        predicted[i] = predicted_steps(rest->radius, threshold);
        bound[i] = error_at(rest->radius, threshold);
        char key[48];
        snprintf(key, sizeof key, "steps_%g_%d", rest->radius, i + 2);
        fig_number(numbers, key, steps[i]);
        snprintf(key, sizeof key, "error_%g_%d", rest->radius, i + 2);
        fig_number(numbers, key, error[i]);
    }
    draw_values(page, &plot[0], rest, steps, predicted);
    draw_values(page, &plot[1], rest, error, bound);
}

static void draw(fig_page *page, FILE *numbers)
{
    const fig_plot plot[2] = {{.box = {40, 24, 140, 130},
                               .x = {1e-12, 0.01},
                               .y = {1, 1000},
                               .log_x = true,
                               .log_y = true,
                               .ticks_x = 3,
                               .name_x = "threshold",
                               .name_y = "steps"},
                              {.box = {236, 24, 140, 130},
                               .x = {1e-12, 0.01},
                               .y = {1e-12, 1},
                               .log_x = true,
                               .log_y = true,
                               .ticks_x = 3,
                               .name_x = "threshold",
                               .name_y = "time before contact"}};
    for (int i = 0; i < 2; i++)
        fig_plot_frame(page, &plot[i]);
    for (int i = 0; i < POINTS; i++) {
        draw_point(page, plot, &rests[i], numbers);
        fig_plot_key(page, 44 + 70 * i, 14, rests[i].name, rests[i].role);
    }
}

const fig_figure fig_advancement_steps = {
    .name = "advancement-steps",
    .title = "Conservative advancement: steps and error by threshold",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
