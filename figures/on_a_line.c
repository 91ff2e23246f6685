// Two points that move along a line, and what the signs of their distances at
// both ends tell.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "stage/plot.h"

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
        tf_point_edge(&tf_exact, &p, (tf_worldline[]){q, q}, &contact);
    TF_REQUIRE(status == TF_OK);
    return contact.verdict == TF_HIT ? (contact.toi_lo + contact.toi_hi) / 2
                                     : -1;
}

static void draw_line(tf_page *page, const tf_plot *plot, const double x[2],
                      tf_role role, double width)
{
    double at[2][2] = {{x[0], 0}, {x[1], 1}};
    tf_plot_curve(page, plot, 2, (const double(*)[2])at,
                  (tf_stroke){.paint.role = role, .width = width});
}

static void draw_race(tf_page *page, const race *r, tf_box box, double time)
{
    tf_plot plot = {
        .box = box, .x = {0, 1.05}, .y = {0, 1}, .ticks_x = -1, .ticks_y = -1};
    tf_plot_frame(page, &plot);
    draw_line(page, &plot, r->q, TF_ROLE_EDGE, 4);
    draw_line(page, &plot, r->p, TF_ROLE_POINT, 1.6);
    if (time >= 0) {
        double at[2];
        tf_plot_place(&plot, r->p[0] + time * (r->p[1] - r->p[0]), time, at);
        tf_page_dot(page, at[0], at[1], 6, (tf_paint){.role = TF_ROLE_CONTACT});
    }
    tf_page_text(page, box.x - 4, box.y + 6, TF_ALIGN_RIGHT, "$t$",
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    tf_page_caption(page, box, r->title);
}

static void draw(tf_page *page, FILE *numbers)
{
    double width = (tf_page_width(page) - 12 - (RACES - 1) * 16) / RACES;
    for (int i = 0; i < RACES; i++) {
        double time = first_time(&races[i]);
        draw_race(page, &races[i],
                  (tf_box){12 + i * (width + 16), 8, width, 84}, time);
        if (i == 1)
            tf_figure_number(numbers, "overtakes", time);
    }
}

const tf_figure tf_figure_on_a_line = {
    .name = "on-a-line",
    .title = "Two points on a line",
    .width = TF_FIGURE_WIDTH,
    .height = 116,
    .draw = draw,
};
