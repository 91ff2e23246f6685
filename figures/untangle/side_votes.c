// A bulge of one curve through another in the plane: what votes, what is pushed,
// and where it is after one push.
#include "base/require.h"
#include "kit/figures.h"
#include "renderer/plot.h"
#include "surface/check.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    LOWER = 26, ///< vertices of the curve that is passed through
    UPPER = 33, ///< of the curve with the bulge
    VERTICES = LOWER + UPPER,
    EDGES = VERTICES - 2,
    PANELS = 2,
    CROSSINGS = 2
};

/// How far beyond the other curve a vertex is pushed, of the mean edge.
static const double margin = 0.6;

typedef struct curves {
    tf_surface *surface;
    double x[2 * VERTICES], mean;
    int edge[2 * EDGES];
    int crossed[CROSSINGS][2]; ///< vertices: the edge's first one, of the lower
                               ///< and of the upper curve
    int crossings, votes;      ///< the sum of the votes
    double side;               ///< to which the wrong vertices are pushed
    bool wrong[VERTICES];
    fig_point foot[VERTICES]; ///< nearest points on the other curve's edges
    int nearest[VERTICES];    ///< the first vertex of the edge; -1: none
    double part[VERTICES];    ///< how far along the edge
    double push[2 * VERTICES];
} curves;

static fig_point at(const curves *c, int v)
{
    return (fig_point){c->x[2 * (ptrdiff_t)v], c->x[2 * v + 1]};
}

static void place(curves *c, int v, double x, double y)
{
    c->x[2 * (ptrdiff_t)v] = x;
    c->x[2 * v + 1] = y;
}

static void make_curves(curves *c)
{
    for (int v = 0, e = 0; v < VERTICES; v++) {
        bool lower = v < LOWER;
        double s = lower ? 2. * v / (LOWER - 1) - 1
                         : 2. * (v - LOWER) / (UPPER - 1) - 1;
        if (lower)
            place(c, v, 1.05 * s, 0.06 * sin(3 * s + 0.5));
        else
            place(c, v, 1.05 * s, 0.34 - 0.74 * exp(-5 * s * s) + 0.03 * s);
        if (v == LOWER - 1 || v == VERTICES - 1)
            continue;
        c->edge[e++] = v;
        c->edge[e++] = v + 1;
    }
}

// What the library finds ------------------------------------------------------

static size_t count_crossings(curves *c, const tf_crossing **row)
{
    tf_mesh mesh = {
        .axes = 2, .vertices = VERTICES, .edges = EDGES, .edge = c->edge};
    tf_crossings found;
    if (!c->surface)
        TF_REQUIRE(tf_surface_create(&mesh, &c->surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_check(c->surface, VERTICES, c->x, NULL, &found,
                                NULL) == TF_OK);
    *row = found.crossing;
    return found.count;
}

static void find_crossings(curves *c)
{
    const tf_crossing *row;
    c->crossings = (int)count_crossings(c, &row);
    TF_REQUIRE(c->crossings == CROSSINGS);
    for (int i = 0; i < CROSSINGS; i++) {
        c->crossed[i][0] = row[i].vertex[0];
        c->crossed[i][1] = row[i].vertex[2];
    }
}

static int between(const curves *c, int v, int curve)
{
    int a = c->crossed[0][curve], b = c->crossed[1][curve];
    return v > (a < b ? a : b) && v <= (a < b ? b : a);
}

/// The normal of an edge, to its left.
static fig_point normal_of(const curves *c, int first)
{
    fig_point a = at(c, first), b = at(c, first + 1);
    double length = hypot(b.x - a.x, b.y - a.y);
    return (fig_point){-(b.y - a.y) / length, (b.x - a.x) / length};
}

/// At a crossing the wrong end of the upper edge votes for the other side of
/// the lower one.
static int vote(const curves *c, int i)
{
    int first = c->crossed[i][1];
    int wrong = c->wrong[first] ? first : first + 1;
    fig_point n = normal_of(c, c->crossed[i][0]), w = at(c, wrong),
              r = at(c, wrong == first ? first + 1 : first);
    return n.x * (r.x - w.x) + n.y * (r.y - w.y) > 0 ? 1 : -1;
}

// The push ----------------------------------------------------------------------

static void find_nearest(curves *c, int v)
{
    double best = HUGE_VAL;
    c->nearest[v] = -1;
    for (int e = 0; e < EDGES; e++) {
        int first = c->edge[2 * (ptrdiff_t)e];
        if ((first < LOWER) == (v < LOWER))
            continue;
        fig_point a = at(c, first), b = at(c, first + 1), p = at(c, v);
        double dx = b.x - a.x, dy = b.y - a.y;
        double part =
            ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
        part = fmin(1, fmax(0, part));
        fig_point foot = {a.x + part * dx, a.y + part * dy};
        double distance = hypot(p.x - foot.x, p.y - foot.y);
        if (distance >= best)
            continue;
        best = distance;
        c->nearest[v] = first;
        c->part[v] = part;
        c->foot[v] = foot;
    }
}

/// Vertices of the bulge are pushed to the side of the lower curve that won, and
/// what they have passed to the other side: half each.
static void find_push(curves *c)
{
    double weight[VERTICES] = {0};
    for (int v = LOWER; v < VERTICES; v++) {
        if (!c->wrong[v])
            continue;
        find_nearest(c, v);
        fig_point n = normal_of(c, c->nearest[v]), p = at(c, v);
        double gap =
            c->side * ((p.x - c->foot[v].x) * n.x + (p.y - c->foot[v].y) * n.y);
        double half = c->side * (margin * c->mean - gap) / 2;
        for (int i = -1; i < 2; i++) {
            int w = i < 0 ? v : c->nearest[v] + i;
            double share = i < 0 ? 1 : i == 0 ? 1 - c->part[v] : c->part[v];
            double way = i < 0 ? half : -half;
            c->push[2 * (ptrdiff_t)w] += share * way * n.x;
            c->push[2 * w + 1] += share * way * n.y;
            weight[w] += share;
        }
    }
    for (int v = 0; v < VERTICES; v++)
        for (int k = 0; k < 2 && weight[v] > 0; k++)
            c->push[2 * v + k] /= weight[v];
}

static void look(curves *c)
{
    find_crossings(c);
    c->mean = 2.1 / (UPPER - 1);
    for (int v = 0; v < VERTICES; v++)
        c->wrong[v] = between(c, v, v >= LOWER);
    for (int i = 0; i < CROSSINGS; i++)
        c->votes += vote(c, i);
    c->side = c->votes > 0 ? 1 : -1;
    find_push(c);
}

// Drawing -----------------------------------------------------------------------

static fig_role role_of(const curves *c, int v)
{
    return c->wrong[v] ? FIG_ROLE_POINT
           : v < LOWER ? FIG_ROLE_TRIANGLE
                       : FIG_ROLE_EDGE;
}

static void draw_curves(fig_page *page, const fig_plot *plot, const curves *c)
{
    for (int e = 0; e < EDGES; e++) {
        int v = c->edge[2 * (ptrdiff_t)e];
        fig_plot_curve(
            page, plot, 2, (fig_point[]){at(c, v), at(c, v + 1)},
            (fig_stroke){.paint = {.role = v < LOWER ? FIG_ROLE_TRIANGLE
                                                     : FIG_ROLE_EDGE},
                         .width = 1.6});
    }
    for (int v = 0; v < VERTICES; v++)
        fig_plot_dot(page, plot, at(c, v).x, at(c, v).y, c->wrong[v] ? 4.2 : 3,
                     role_of(c, v));
}

static void draw_arrow(fig_page *page, const fig_plot *plot, fig_point from,
                       fig_point by, fig_role role)
{
    fig_point to = {from.x + by.x, from.y + by.y};
    fig_point line[2] = {fig_plot_place(plot, from.x, from.y),
                         fig_plot_place(plot, to.x, to.y)};
    if (hypot(line[1].x - line[0].x, line[1].y - line[0].y) > 3)
        fig_page_line(page, 2, line,
                      (fig_stroke){.paint = {.role = role}, .arrow = true});
}

static fig_point crossing_of(const curves *c, int i)
{
    fig_point a = at(c, c->crossed[i][0]), b = at(c, c->crossed[i][0] + 1);
    fig_point p = at(c, c->crossed[i][1]), q = at(c, c->crossed[i][1] + 1);
    double u = (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
    double w = (q.x - a.x) * (b.y - a.y) - (q.y - a.y) * (b.x - a.x);
    double part = u / (u - w);
    return (fig_point){p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
}

static void draw_votes(fig_page *page, const fig_plot *plot, const curves *c)
{
    for (int i = 0; i < CROSSINGS; i++) {
        fig_point n = normal_of(c, c->crossed[i][0]), p = crossing_of(c, i);
        double way = 0.25 * vote(c, i);
        draw_arrow(page, plot, p, (fig_point){way * n.x, way * n.y},
                   FIG_ROLE_CONTACT);
        fig_plot_dot(page, plot, p.x, p.y, FIG_WIDTH_BALL, FIG_ROLE_CONTACT);
    }
}

static fig_plot panel(fig_page *page, int i, const char *title)
{
    double width = fig_page_width(page) / PANELS;
    fig_plot plot = {.box = {width * i + 4, 18, width - 8, 92},
                     .x = {-1.08, 1.08},
                     .y = {-0.5, -0.5 + 2.16 * 92 / (width - 8)}};
    fig_page_title(page, plot.box, title);
    return plot;
}

static void draw(fig_page *page, FILE *numbers)
{
    curves c = {0};
    make_curves(&c);
    look(&c);
    fig_plot before = panel(page, 0, "two votes, and the pushes");
    fig_plot after = panel(page, 1, "after one push");
    draw_curves(page, &before, &c);
    int wrong = 0, pushed = 0;
    for (int v = 0; v < VERTICES; v++) {
        const double *push = c.push + 2 * (ptrdiff_t)v;
        draw_arrow(page, &before, at(&c, v), (fig_point){push[0], push[1]},
                   FIG_ROLE_INK);
        wrong += c.wrong[v];
        pushed += push[0] != 0 || push[1] != 0;
    }
    draw_votes(page, &before, &c);
    for (int i = 0; i < 2 * VERTICES; i++)
        c.x[i] += c.push[i];
    draw_curves(page, &after, &c);
    const tf_crossing *row;
    fig_number(numbers, "before", c.crossings);
    fig_number(numbers, "votes", c.votes > 0 ? c.votes : -c.votes);
    fig_number(numbers, "wrong", wrong);
    fig_number(numbers, "pushed", pushed);
    fig_number(numbers, "after", (double)count_crossings(&c, &row));
    tf_surface_free(c.surface);
}

const fig_figure fig_side_votes = {
    .name = "side-votes",
    .title = "A bulge through a curve: votes and pushes",
    .width = FIG_PAGE_WIDTH,
    .height = 116,
    .draw = draw,
};
