// An edge at half time in the two orders of its ends, and a point that meets
// it in one of them.
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

/// The time at which the edge is shown.
static const double middle = 0.5;

/// The first and the second end of the edge, each from its start to its end.
static const double end[2][2][2] = {{{0, 0}, {0, 1}}, {{4, 0}, {4, 2}}};

static const double point[2][2] = {{4.5, 0.5}, {0.5, 1.5}};

static const fig_box panel_box[2] = {{6, 20, 180, 75}, {198, 20, 180, 75}};

/// The edge with the end `first` as vertex 0.
static void make_edge(int first, tf_worldline edge[2])
{
    for (int i = 0; i < 2; i++) {
        int own = i == 0 ? first : 1 - first;
        edge[i] = tf_worldline_between(2, end[own][0], end[own][1]);
    }
}

static void draw_line(fig_page *page, const fig_plot *plot, int count,
                      const tf_vector world[], fig_stroke stroke)
{
    fig_point at[3];
    for (int i = 0; i < count; i++)
        at[i] = fig_plot_place(plot, world[i].x[0], world[i].x[1]);
    fig_page_line(page, count, at, stroke);
}

/// The bent edge, and the straight one dashed.
static void draw_edge(fig_page *page, const fig_plot *plot,
                      const tf_worldline edge[2])
{
    tf_vector bent[3];
    fig_world_of_edge(edge, middle, bent);
    draw_line(page, plot, 2, (tf_vector[]){bent[0], bent[2]},
              (fig_stroke){.paint = {.role = FIG_ROLE_EDGE},
                           .width = FIG_WIDTH_THIN,
                           .dash = 3});
    draw_line(page, plot, 3, bent,
              (fig_stroke){.paint = {.role = FIG_ROLE_EDGE},
                           .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < 3; i += 2) {
        fig_point at = fig_plot_dot(page, plot, bent[i].x[0], bent[i].x[1],
                                    FIG_WIDTH_BALL, FIG_ROLE_EDGE);
        fig_page_label(page, at.x, at.y,
                       (fig_label){.text = i == 0 ? "$e_0$" : "$e_1$",
                                   .role = FIG_ROLE_EDGE,
                                   .side = FIG_SIDE_S});
    }
    fig_plot_dot(page, plot, bent[1].x[0], bent[1].x[1], 4.5, FIG_ROLE_EDGE);
}

/// The path of the point.
static void draw_path(fig_page *page, const fig_plot *plot)
{
    const tf_vector path[2] = {{{point[0][0], point[0][1], 0}},
                               {{point[1][0], point[1][1], 0}}};
    draw_line(page, plot, 2, path,
              (fig_stroke){.paint = {.role = FIG_ROLE_POINT}, .arrow = true});
}

/// A ring where the point starts.
static void draw_start(fig_page *page, const fig_plot *plot)
{
    fig_point at = fig_plot_dot(page, plot, point[0][0], point[0][1],
                                FIG_WIDTH_BALL, FIG_ROLE_POINT);
    fig_page_dot(page, at.x, at.y, FIG_WIDTH_BALL - 2.2,
                 (fig_paint){.role = FIG_ROLE_PAPER});
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = "$t = 0$",
                               .role = FIG_ROLE_POINT,
                               .side = FIG_SIDE_S,
                               .gap = 6});
}

/// Where the point is at half time.
static void draw_point(fig_page *page, const fig_plot *plot, bool hit)
{
    fig_role role = hit ? FIG_ROLE_CONTACT : FIG_ROLE_POINT;
    fig_point at = fig_plot_dot(page, plot, (point[0][0] + point[1][0]) / 2,
                                (point[0][1] + point[1][1]) / 2,
                                hit ? FIG_WIDTH_MARK : FIG_WIDTH_BALL, role);
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = hit ? "contact" : "$p$",
                               .role = role,
                               .side = FIG_SIDE_NE,
                               .gap = 6});
}

static void draw_order(fig_page *page, int first, FILE *numbers)
{
    tf_worldline edge[2];
    make_edge(first, edge);
    tf_worldline p = tf_worldline_between(2, point[0], point[1]);
    tf_contact contact;
    tf_status status = tf_query(&tf_exact, 2, 1, &p, 2, edge, &contact);
    TF_REQUIRE(status == TF_OK);
    bool hit = contact.verdict == TF_HIT;
    fig_plot plot = {
        .box = panel_box[first], .x = {-0.4, 5.1}, .y = {-0.35, 1.94}};
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    draw_path(page, &plot);
    draw_edge(page, &plot, edge);
    draw_start(page, &plot);
    draw_point(page, &plot, hit);
    fig_page_title(page, plot.box,
                   first == 0 ? "right end pulls first"
                              : "left end pulls first");
    fig_page_caption(page, plot.box, hit ? "*hit*" : "*apart*");
    if (hit)
        fig_number(numbers, "toi", fig_toi(&contact));
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int first = 0; first < 2; first++)
        draw_order(page, first, numbers);
}

const fig_figure fig_edge_orders = {
    .name = "edge-orders",
    .title = "An edge at half time in the two orders of its ends",
    .width = FIG_PAGE_WIDTH,
    .height = 116,
    .draw = draw,
};
