// Two points that move along a line, and what the signs of their distances at
// both ends tell.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

/// Two points, from t = 0 to t = 1.
typedef struct race {
    const char *title;
    double p[2], q[2];
} race;

static const race races[] = {
    {"*one stays ahead*", {0.1, 0.45}, {0.4, 0.95}},
    {"*one overtakes*", {0.1, 0.9}, {0.4, 0.5}},
    {"*equal at an end*", {0.1, 0.7}, {0.5, 0.7}},
    {"*side by side*", {0.2, 0.8}, {0.2, 0.8}},
};

enum {
    RACES = 4
};

/// When they meet first; -1 if they do not.  In the plane, q is an edge of no
/// length.
static double first_time(const race *r)
{
    tf_worldline p =
        tf_worldline_between(2, (double[]){r->p[0], 0}, (double[]){r->p[1], 0});
    tf_worldline q =
        tf_worldline_between(2, (double[]){r->q[0], 0}, (double[]){r->q[1], 0});
    tf_contact contact;
    tf_status status =
        tf_query(&tf_exact, 2, 1, &p, 2, (tf_worldline[]){q, q}, &contact);
    TF_REQUIRE(status == TF_OK);
    return fig_toi(&contact);
}

/// The worldline of a point between its places at both times.
static void draw_line(fig_page *page, const fig_plot *plot, const double x[2],
                      fig_role role, double width)
{
    fig_point at[2] = {{x[0], 0}, {x[1], 1}};
    fig_plot_curve(page, plot, 2, at,
                   (fig_stroke){.paint.role = role, .width = width});
}

/// The names of the two points below where they start.
static void name_starts(fig_page *page, const fig_plot *plot, const race *r)
{
    bool together = r->p[0] == r->q[0];
    fig_point p = fig_plot_place(plot, r->p[0], 0),
              q = fig_plot_place(plot, r->q[0], 0);
    double apart = together ? 5 : 0, below = 11;
    fig_page_text(page, p.x - apart, p.y + below, FIG_ALIGN_CENTER, "$p$",
                  FIG_LETTERS, FIG_ROLE_POINT);
    fig_page_text(page, q.x + apart, q.y + below, FIG_ALIGN_CENTER, "$q$",
                  FIG_LETTERS, FIG_ROLE_EDGE);
}

static void draw_race(fig_page *page, const race *r, fig_box box, double time)
{
    fig_plot plot = {
        .box = box, .x = {0, 1.05}, .y = {0, 1}, .ticks_x = -1, .ticks_y = -1};
    fig_plot_frame(page, &plot);
    draw_line(page, &plot, r->q, FIG_ROLE_EDGE, 4);
    draw_line(page, &plot, r->p, FIG_ROLE_POINT, 1.6);
    if (time >= 0) {
        fig_plot_dot(page, &plot, r->p[0] + time * (r->p[1] - r->p[0]), time, 6,
                     FIG_ROLE_CONTACT);
    }
    name_starts(page, &plot, r);
    double left = box.x - 4, bottom = box.y + box.height;
    fig_page_text(page, left, box.y + 6, FIG_ALIGN_RIGHT, "$1$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, left, box.y + box.height / 2 + 3, FIG_ALIGN_RIGHT,
                  "$t$", FIG_LETTERS, FIG_ROLE_INK);
    fig_page_text(page, left, bottom + 3, FIG_ALIGN_RIGHT, "$0$",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_page_text(page, box.x + box.width, bottom + 11, FIG_ALIGN_RIGHT, "$x$",
                  FIG_LETTERS, FIG_ROLE_INK);
    fig_page_caption(page, (fig_box){box.x, box.y, box.width, box.height + 12},
                     r->title);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = (fig_page_width(page) - 18 - (RACES - 1) * 16) / RACES;
    for (int i = 0; i < RACES; i++) {
        double time = first_time(&races[i]);
        draw_race(page, &races[i],
                  (fig_box){12 + i * (width + 16), 8, width, 84}, time);
        if (i == 1)
            fig_number(numbers, "overtakes", time);
    }
}

const fig_figure fig_points_on_a_line = {
    .name = "points-on-a-line",
    .title = "Two points on a line: apart, and in three contacts",
    .width = FIG_PAGE_WIDTH,
    .height = 128,
    .draw = draw,
};
