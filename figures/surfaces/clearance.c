// Two edges in a plane, a direction along which they are apart, and how far
// their vertices may move until it no longer shows that.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "base/require.h"
#include "fast/vectorized.h"

#include <math.h>

/// The vertices of both edges, a and b, c and d, at rest.
static const double at[4][3] = {
    {0.2, 0.3, 0}, {2, -0.1, 0}, {1.2, 1.5, 0}, {3.1, 1.2, 0}};

/// What the page shows of the plane.
static const fig_box shown = {-0.4, -0.82, 4.1, 2.83};
static const fig_box box = {8, 6, 368, 254};

static fig_point place(double x, double y)
{
    double scale = box.width / shown.width;
    return (fig_point){box.x + (x - shown.x) * scale,
                       box.y + box.height - (y - shown.y) * scale};
}

/// As the library measures it.
static double clearance_of_edges(void)
{
    tf_motion rest = {3, 4, at[0], at[0]};
    const int vertex[] = {0, 1, 2, 3};
    tf_queries queries = {TF_EDGE_EDGE, &rest, 1, vertex};
    tf_verdict verdict;
    size_t separated = 0;
    double clearance;
    TF_REQUIRE(tf_vectorized.measure(NULL, &tf_exact, &queries, &verdict,
                                     &separated, &clearance) == TF_OK);
    return clearance;
}

/// The direction from the middle of one edge to that of the other.
static void find_direction(double n[2])
{
    for (int k = 0; k < 2; k++)
        n[k] = (at[2][k] + at[3][k] - at[0][k] - at[1][k]) / 2;
}

// The strip between the edges -------------------------------------------------

/// A point of the strip: `across` is 0 on the side of b, 1 on that of c.
static fig_point in_strip(const double n[2], double gap, double across,
                          double along)
{
    double length = hypot(n[0], n[1]);
    double up = across * gap / length;
    return place(at[1][0] + (n[0] * up - n[1] * along) / length,
                 at[1][1] + (n[1] * up + n[0] * along) / length);
}

static void draw_strip(fig_page *page, const double n[2], double gap)
{
    const double low = -0.95, high = 2.4;
    fig_point strip[] = {in_strip(n, gap, 0, low), in_strip(n, gap, 0, high),
                         in_strip(n, gap, 1, high), in_strip(n, gap, 1, low)};
    fig_page_fill(page, 4, strip,
                  (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.18});
    fig_point middle[] = {in_strip(n, gap, 0.5, low),
                          in_strip(n, gap, 0.5, high)};
    fig_page_line(page, 2, middle,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_THIN,
                               .dash = 3});
    fig_point arrow[] = {in_strip(n, gap, 0, -0.7), in_strip(n, gap, 1, -0.7)};
    fig_page_line(page, 2, arrow,
                  (fig_stroke){.paint = {.role = FIG_ROLE_INK},
                               .width = FIG_WIDTH_LINE,
                               .arrow = true});
    fig_point name = in_strip(n, gap, 0.75, -0.82);
    fig_page_text(page, name.x, name.y + 4, FIG_ALIGN_CENTER, "$n$",
                  FIG_LETTERS, FIG_ROLE_INK);
}

// The edges, and where their vertices may go ----------------------------------

/// All places with |dx| + |dy| of at most `far`.
static void draw_reach(fig_page *page, const double x[3], double far,
                       fig_role role)
{
    fig_point diamond[] = {place(x[0] + far, x[1]), place(x[0], x[1] + far),
                           place(x[0] - far, x[1]), place(x[0], x[1] - far)};
    fig_page_fill(page, 4, diamond, (fig_paint){.role = role, .opacity = 0.3});
}

static void draw_edge(fig_page *page, int first, double far, fig_role role,
                      const char *const names[2], fig_side side)
{
    fig_point edge[2];
    for (int i = 0; i < 2; i++) {
        const double *x = at[first + i];
        draw_reach(page, x, far, role);
        edge[i] = place(x[0], x[1]);
    }
    fig_page_line(
        page, 2, edge,
        (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < 2; i++) {
        fig_page_dot(page, edge[i].x, edge[i].y, FIG_WIDTH_BALL,
                     (fig_paint){.role = role});
        fig_page_label(
            page, edge[i].x, edge[i].y,
            (fig_label){.text = names[i], .role = role, .side = side});
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double n[2], clearance = clearance_of_edges();
    find_direction(n);
    double gap = n[0] * (at[2][0] - at[1][0]) + n[1] * (at[2][1] - at[1][1]);
    TF_REQUIRE(fabs(gap / n[1] - clearance) < 1e-9);

    draw_strip(page, n, gap);
    draw_edge(page, 0, clearance / 2, FIG_ROLE_POINT,
              (const char *[]){"$a$", "$b$"}, FIG_SIDE_SW);
    draw_edge(page, 2, clearance / 2, FIG_ROLE_EDGE,
              (const char *[]){"$c$", "$d$"}, FIG_SIDE_NE);
    fig_number(numbers, "clearance", clearance);
}

const fig_figure fig_clearance = {
    .name = "clearance",
    .title = "How far the vertices of two edges may move",
    .width = FIG_PAGE_WIDTH,
    .height = 266,
    .draw = draw,
};
