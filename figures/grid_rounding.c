// What rounding to a grid does to a point, to a triangle and to two edges.
#include "figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "spacetime/complementary.h"
#include "stage/plot.h"

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
        pair.side[pair.count++] = i / 2 == 0 ? +1 : -1;
    }
    pair.early = pair.count;
    tf_meeting meeting;
    return tf_complementary_meet(arithmetic_of(rounded), &pair, &meeting) &&
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
static tf_plot plot_of(int panel, const double low[2], double side)
{
    double margin =
        (TF_FIGURE_WIDTH - PANELS * panel_side - (PANELS - 1) * gap) / 2;
    return (tf_plot){.box = {margin + panel * (panel_side + gap), panel_top,
                             panel_side, panel_side},
                     .x = {low[0], low[0] + side},
                     .y = {low[1], low[1] + side}};
}

/// All points of the grid that lie in the plot.
static void draw_grid(tf_page *page, const tf_plot *plot)
{
    tf_page_fill_box(page, plot->box,
                     (tf_paint){.role = TF_ROLE_NEUTRAL, .opacity = 0.09});
    for (int j = (int)ceil(plot->y[0]); j <= plot->y[1]; j++)
        for (int i = (int)ceil(plot->x[0]); i <= plot->x[1]; i++) {
            double at[2];
            tf_plot_place(plot, i, j, at);
            tf_page_dot(page, at[0], at[1], 2,
                        (tf_paint){.role = TF_ROLE_NEUTRAL});
        }
}

/// A polyline through some places, as they are (dashed) or rounded.
static void draw_shape(tf_page *page, const tf_plot *plot, int count,
                       const double place[][2], bool rounded, tf_role role)
{
    double at[CORNERS][2];
    for (int i = 0; i < count; i++) {
        tf_event event = event_at(place[i], rounded);
        tf_plot_place(plot, event.x[0], event.x[1], at[i]);
        tf_page_dot(page, at[i][0], at[i][1], rounded ? 5 : 3.5,
                    (tf_paint){.role = role});
    }
    tf_page_line(page, count, (const double(*)[2])at,
                 (tf_stroke){.paint.role = role,
                             .width = rounded ? TF_WIDTH_LINE : TF_WIDTH_THIN,
                             .dash = rounded ? 0 : 2.5,
                             .closed = count > 2});
    if (count > 2 && rounded)
        tf_page_fill(page, count, (const double(*)[2])at,
                     (tf_paint){.role = role, .opacity = 0.25});
}

/// The cell of (2, 2), and what rounding does to points in it.
static void draw_cell(tf_page *page)
{
    tf_plot plot = plot_of(0, (double[]){0.75, 0.75}, 2.5);
    draw_grid(page, &plot);
    double corner[4][2], center[2];
    for (int i = 0; i < 4; i++)
        tf_plot_place(&plot, i % 3 == 0 ? 1.5 : 2.5, i < 2 ? 1.5 : 2.5,
                      corner[i]);
    tf_page_fill(page, 4, (const double(*)[2])corner,
                 (tf_paint){.role = TF_ROLE_POINT, .opacity = 0.2});
    tf_plot_place(&plot, 2, 2, center);
    for (int i = 0; i < (int)(sizeof moved / sizeof *moved); i++) {
        double way[2][2] = {{0, 0}, {center[0], center[1]}};
        tf_plot_place(&plot, moved[i][0], moved[i][1], way[0]);
        tf_page_line(
            page, 2, (const double(*)[2])way,
            (tf_stroke){.paint.role = TF_ROLE_POINT, .width = TF_WIDTH_THIN});
        tf_page_dot(page, way[0][0], way[0][1], 3.5,
                    (tf_paint){.role = TF_ROLE_POINT});
    }
    tf_page_dot(page, center[0], center[1], 5,
                (tf_paint){.role = TF_ROLE_POINT});
    tf_page_caption(page, plot.box, "*to the nearest point*");
}

static void draw_triangle(tf_page *page)
{
    tf_plot plot = plot_of(1, (double[]){-0.5, -0.9}, 5);
    draw_grid(page, &plot);
    draw_shape(page, &plot, CORNERS, triangle, true, TF_ROLE_TRIANGLE);
    draw_shape(page, &plot, CORNERS, triangle, false, TF_ROLE_INK);
    tf_page_caption(page, plot.box, "*a triangle turns over*");
}

static void draw_edges(tf_page *page)
{
    static const tf_role role[EDGES] = {TF_ROLE_EDGE, TF_ROLE_OTHER_EDGE};
    tf_plot plot = plot_of(2, (double[]){-0.5, -0.9}, 5);
    draw_grid(page, &plot);
    for (int rounded = 1; rounded >= 0; rounded--)
        for (int i = 0; i < EDGES; i++)
            draw_shape(page, &plot, 2, edges[i], rounded, role[i]);
    tf_page_caption(page, plot.box, "*two edges cross*");
}

static void draw(tf_page *page, FILE *numbers)
{
    draw_cell(page);
    draw_triangle(page);
    draw_edges(page);
    tf_figure_number(numbers, "double_area", double_area(false));
    tf_figure_number(numbers, "double_area_rounded", double_area(true));
    tf_figure_number(numbers, "distance", edge_distance());
    tf_figure_number(numbers, "cross", edges_cross(false));
    tf_figure_number(numbers, "cross_rounded", edges_cross(true));
}

const tf_figure tf_figure_grid_rounding = {
    .name = "grid-rounding",
    .title = "A point, a triangle and two edges, rounded to a grid",
    .width = TF_FIGURE_WIDTH,
    .height = 148,
    .draw = draw,
};
