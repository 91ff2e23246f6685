// What rounding to a grid does to a point, to a triangle and to two edges.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "intersect/complementary.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    PANELS = 3,
    CORNERS = 3,
    EDGES = 2
};

static const double panel_side = 116, gap = 12, panel_top = 8;

/// Points that round to (2, 2).
static const double moved[][2] = {
    {1.5625, 1.5625}, {2.4375, 1.6875}, {1.8125, 2.4375}, {2.3125, 2.1875}};

static const double triangle[CORNERS][2] = {
    {0.375, 0.375}, {3.625, 2.5625}, {1.5625, 1.4375}};

static const double edges[EDGES][2][2] = {{{0.375, 0.4375}, {3.5625, 2.5625}},
                                          {{0.4375, 0.5625}, {3.25, 2.46875}}};

// Before and after -------------------------------------------------------

/// A place as it is, or rounded.
static tf_event event_at(const double place[2], bool rounded)
{
    tf_event event = {.t = 0};
    for (int k = 0; k < 2; k++)
        event.x[k] = rounded ? round(place[k]) : place[k];
    return event;
}

static const tf_arithmetic *arithmetic_of(bool rounded)
{
    return rounded ? &tf_integer64 : &tf_exact;
}

/// Twice the area of the triangle, positive counterclockwise.
static double double_area(bool rounded)
{
    tf_event corner[CORNERS];
    for (int i = 0; i < CORNERS; i++)
        corner[i] = event_at(triangle[i], rounded);
    tf_differences d = {.n = 2,
                        .to = {&corner[1], &corner[2]},
                        .from = {&corner[0], &corner[0]},
                        .axis = {0, 1}};
    tf_value value = arithmetic_of(rounded)->value(&d);
    return ldexp(value.number, value.exponent);
}

/// Whether the edges cross: four events of one time are complementary in the
/// plane.
static bool edges_cross(bool rounded)
{
    tf_event end[2 * EDGES];
    tf_pair pair = {.axes = 2, .axis = {0, 1}};
    for (int i = 0; i < 2 * EDGES; i++) {
        end[i] = event_at(edges[i / 2][i % 2], rounded);
        pair.event[pair.count] = &end[i];
        pair.operand[pair.count++] = i / 2 == 0 ? +1 : -1;
    }
    pair.start_count = pair.count;
    tf_intersection meeting;
    return tf_complementary_intersect(arithmetic_of(rounded), &pair,
                                      TF_WITH_POINT, &meeting) &&
           meeting.verdict == TF_HIT;
}

/// The distance of an end of one edge from the other edge.
static double end_distance(const double end[2], const double edge[2][2])
{
    double along[2], offset[2];
    for (int k = 0; k < 2; k++) {
        along[k] = edge[1][k] - edge[0][k];
        offset[k] = end[k] - edge[0][k];
    }
    double s = (offset[0] * along[0] + offset[1] * along[1]) /
               (along[0] * along[0] + along[1] * along[1]);
    s = fmax(0, fmin(s, 1));
    return hypot(offset[0] - s * along[0], offset[1] - s * along[1]);
}

/// How far apart the edges are; they do not cross.
static double edge_distance(void)
{
    double least = INFINITY;
    for (int i = 0; i < EDGES; i++)
        for (int j = 0; j < 2; j++)
            least = fmin(least, end_distance(edges[i][j], edges[1 - i]));
    return least;
}

// Drawing ----------------------------------------------------------------

/// A panel that shows the square from `low` to `low` + `side`.
static fig_plot plot_of(int panel, fig_point low, double side)
{
    double margin =
        (FIG_PAGE_WIDTH - PANELS * panel_side - (PANELS - 1) * gap) / 2;
    return (fig_plot){.box = {margin + panel * (panel_side + gap), panel_top,
                              panel_side, panel_side},
                      .x = {low.x, low.x + side},
                      .y = {low.y, low.y + side}};
}

/// All points of the grid that lie in the plot.
static void draw_grid(fig_page *page, const fig_plot *plot)
{
    fig_page_fill_box(page, plot->box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    for (int j = (int)ceil(plot->y[0]); j <= plot->y[1]; j++)
        for (int i = (int)ceil(plot->x[0]); i <= plot->x[1]; i++) {
            fig_plot_dot(page, plot, i, j, 2, FIG_ROLE_NEUTRAL);
        }
}

/// A polyline through some places, as they are (dashed) or rounded.
static void draw_shape(fig_page *page, const fig_plot *plot, int count,
                       const double place[][2], bool rounded, fig_role role)
{
    fig_point at[CORNERS];
    for (int i = 0; i < count; i++) {
        tf_event event = event_at(place[i], rounded);
        at[i] = fig_plot_place(plot, event.x[0], event.x[1]);
        fig_page_dot(page, at[i].x, at[i].y, rounded ? 5 : 3.5,
                     (fig_paint){.role = role});
    }
    fig_page_line(
        page, count, at,
        (fig_stroke){.paint.role = role,
                     .width = rounded ? FIG_WIDTH_LINE : FIG_WIDTH_THIN,
                     .dash = rounded ? 0 : 2.5,
                     .closed = count > 2});
    if (count > 2 && rounded)
        fig_page_fill(page, count, at,
                      (fig_paint){.role = role, .opacity = 0.25});
}

/// The cell of (2, 2), and what rounding does to points in it.
static void draw_cell(fig_page *page)
{
    fig_plot plot = plot_of(0, (fig_point){0.75, 0.75}, 2.5);
    draw_grid(page, &plot);
    fig_point corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] =
            fig_plot_place(&plot, i % 3 == 0 ? 1.5 : 2.5, i < 2 ? 1.5 : 2.5);
    fig_page_fill(page, 4, corner,
                  (fig_paint){.role = FIG_ROLE_POINT, .opacity = 0.2});
    fig_point center = fig_plot_place(&plot, 2, 2);
    for (int i = 0; i < (int)(sizeof moved / sizeof *moved); i++) {
        fig_point way[2] = {fig_plot_place(&plot, moved[i][0], moved[i][1]),
                            center};
        fig_page_line(page, 2, way,
                      (fig_stroke){.paint.role = FIG_ROLE_POINT,
                                   .width = FIG_WIDTH_THIN});
        fig_page_dot(page, way[0].x, way[0].y, 3.5,
                     (fig_paint){.role = FIG_ROLE_POINT});
    }
    fig_page_dot(page, center.x, center.y, 5,
                 (fig_paint){.role = FIG_ROLE_POINT});
    fig_page_caption(page, plot.box, "*to the nearest point*");
}

static void draw_triangle(fig_page *page)
{
    fig_plot plot = plot_of(1, (fig_point){-0.5, -0.9}, 5);
    draw_grid(page, &plot);
    draw_shape(page, &plot, CORNERS, triangle, true, FIG_ROLE_TRIANGLE);
    draw_shape(page, &plot, CORNERS, triangle, false, FIG_ROLE_INK);
    fig_page_caption(page, plot.box, "*a triangle turns over*");
}

static void draw_edges(fig_page *page)
{
    static const fig_role role[EDGES] = {FIG_ROLE_EDGE, FIG_ROLE_OTHER_EDGE};
    fig_plot plot = plot_of(2, (fig_point){-0.5, -0.9}, 5);
    draw_grid(page, &plot);
    for (int rounded = 1; rounded >= 0; rounded--)
        for (int i = 0; i < EDGES; i++)
            draw_shape(page, &plot, 2, edges[i], rounded, role[i]);
    fig_page_caption(page, plot.box, "*two edges cross*");
}

static void draw(fig_page *page, FILE *numbers)
{
    draw_cell(page);
    draw_triangle(page);
    draw_edges(page);
    fig_number(numbers, "double_area", double_area(false));
    fig_number(numbers, "double_area_rounded", double_area(true));
    fig_number(numbers, "distance", edge_distance());
    fig_number(numbers, "cross", edges_cross(false));
    fig_number(numbers, "cross_rounded", edges_cross(true));
}

const fig_figure fig_grid_rounding = {
    .name = "grid-rounding",
    .title = "A point, a triangle and two edges, rounded to a grid",
    .width = FIG_PAGE_WIDTH,
    .height = 148,
    .draw = draw,
};
