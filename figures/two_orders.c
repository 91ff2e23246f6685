// An edge at half time in the two orders of its ends, and a point that meets
// it in one of them.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "stage/plot.h"
#include "worlds.h"

/// The time at which the edge is shown.
static const double middle = 0.5;

/// The first and the second end of the edge, each from its start to its end.
static const double end[2][2][2] = {{{-2, 0}, {-2, 0}}, {{2, 0}, {2, 2}}};

static const double point[2][2] = {{1.75, 1}, {-1.25, 1}};

static const tf_box panel_box[2] = {{6, 20, 180, 100.8}, {198, 20, 180, 100.8}};

/// The edge with the end `first` as vertex 0.
static void make_edge(int first, tf_worldline edge[2])
{
    for (int i = 0; i < 2; i++) {
        const double(*own)[2] = end[i == 0 ? first : 1 - first];
        edge[i] = tf_worldline_between(2, own[0], own[1]);
    }
}

static void draw_line(tf_page *page, const tf_plot *plot, int count,
                      double world[][3], tf_stroke stroke)
{
    double at[3][2];
    for (int i = 0; i < count; i++)
        tf_plot_place(plot, world[i][0], world[i][1], at[i]);
    tf_page_line(page, count, (const double(*)[2])at, stroke);
}

/// The bent edge, and the straight one dashed.
static void draw_edge(tf_page *page, const tf_plot *plot,
                      const tf_worldline edge[2])
{
    double bent[3][3], straight[2][3], at[2];
    tf_world_of_edge(edge, middle, bent);
    for (int k = 0; k < 2; k++) {
        straight[0][k] = bent[0][k];
        straight[1][k] = bent[2][k];
    }
    draw_line(page, plot, 2, straight,
              (tf_stroke){.paint = {.role = TF_ROLE_EDGE},
                          .width = TF_WIDTH_THIN,
                          .dash = 3});
    draw_line(
        page, plot, 3, bent,
        (tf_stroke){.paint = {.role = TF_ROLE_EDGE}, .width = TF_WIDTH_TUBE});
    for (int i = 0; i < 3; i += 2) {
        tf_plot_place(plot, bent[i][0], bent[i][1], at);
        tf_page_dot(page, at[0], at[1], TF_WIDTH_BALL,
                    (tf_paint){.role = TF_ROLE_EDGE});
        tf_page_label(page, at[0], at[1],
                      (tf_label){.text = i == 0 ? "$e_0$" : "$e_1$",
                                 .role = TF_ROLE_EDGE,
                                 .side = TF_SIDE_S});
    }
    tf_plot_place(plot, bent[1][0], bent[1][1], at);
    tf_page_dot(page, at[0], at[1], 4.5, (tf_paint){.role = TF_ROLE_EDGE});
}

/// The way of the point, and where it is at half time.
static void draw_point(tf_page *page, const tf_plot *plot, bool hit)
{
    double way[2][3] = {{point[0][0], point[0][1]}, {point[1][0], point[1][1]}};
    tf_role role = hit ? TF_ROLE_CONTACT : TF_ROLE_POINT;
    double at[2];
    draw_line(page, plot, 2, way,
              (tf_stroke){.paint = {.role = TF_ROLE_POINT}, .arrow = true});
    tf_plot_place(plot, (way[0][0] + way[1][0]) / 2,
                  (way[0][1] + way[1][1]) / 2, at);
    tf_page_dot(page, at[0], at[1], hit ? TF_WIDTH_MARK : TF_WIDTH_BALL,
                (tf_paint){.role = role});
    tf_page_label(page, at[0], at[1],
                  (tf_label){.text = hit ? "contact" : "$p$",
                             .role = role,
                             .side = TF_SIDE_N,
                             .gap = 6});
}

static void draw_order(tf_page *page, int first, FILE *numbers)
{
    tf_worldline edge[2];
    make_edge(first, edge);
    tf_worldline p = tf_worldline_between(2, point[0], point[1]);
    tf_contact contact;
    tf_status status = tf_point_edge(&tf_exact, &p, edge, &contact);
    TF_REQUIRE(status == TF_OK);
    bool hit = contact.verdict == TF_HIT;
    tf_plot plot = {
        .box = panel_box[first], .x = {-2.5, 2.5}, .y = {-0.9, 1.9}};
    tf_page_fill_box(page, plot.box,
                     (tf_paint){.role = TF_ROLE_NEUTRAL, .opacity = 0.09});
    draw_edge(page, &plot, edge);
    draw_point(page, &plot, hit);
    tf_page_title(page, plot.box,
                  first == 0 ? "right end last" : "left end last");
    tf_page_caption(page, plot.box, hit ? "*hit*" : "*apart*");
    if (hit)
        tf_figure_number(numbers, "toi", (contact.toi_lo + contact.toi_hi) / 2);
}

static void draw(tf_page *page, FILE *numbers)
{
    for (int first = 0; first < 2; first++)
        draw_order(page, first, numbers);
}

const tf_figure tf_figure_two_orders = {
    .name = "two-orders",
    .title = "An edge at half time in the two orders of its ends",
    .width = TF_FIGURE_WIDTH,
    .height = 142,
    .draw = draw,
};
