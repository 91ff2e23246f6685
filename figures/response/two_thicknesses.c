// What is at a distance: the points around a triangle, with the features that are
// nearest to them, and two curves with a thickness and without.
#include "base/require.h"
#include "distance/distance.h"
#include "kit/figures.h"
#include "renderer/plot.h"
#include "response/resolve.h"

#include <math.h>
#include <string.h>

enum {
    AROUND = 360, ///< directions from the middle of the triangle
    POINTS = 25,  ///< of each curve
    CURVES = 2
};

static const double pi = 3.14159265358979;
static const double length = 0.5;     ///< from the triangle
static const double thickness = 0.12; ///< of the curves

// Around a triangle -----------------------------------------------------------

static const double corner[] = {0, 0, 0, 2.2, 0.1, 0, 0.7, 1.3, 0};

/// The nearest points of the triangle and a point of its plane.
static tf_nearest nearest_to(fig_point at)
{
    double position[12] = {at.x, at.y, 0};
    static const int vertex[] = {0, 1, 2, 3};
    tf_nearest nearest;
    memcpy(position + 3, corner, sizeof corner);
    TF_REQUIRE(tf_distance(TF_POINT_TRIANGLE, 4, position, vertex, &nearest) ==
               TF_OK);
    return nearest;
}

/// The point in a direction from the middle at the length, by bisection.
static fig_point point_around(double angle)
{
    double low = 0, high = 4;
    fig_point at = {0, 0};
    for (int i = 0; i < 60; i++) {
        double way = (low + high) / 2;
        at = (fig_point){0.97 + way * cos(angle), 0.47 + way * sin(angle)};
        *(nearest_to(at).lower < length ? &low : &high) = way;
    }
    return at;
}

/// How many corners the nearest feature has.
static int feature_of(fig_point at)
{
    tf_nearest nearest = nearest_to(at);
    int corners = 0;
    for (int i = 0; i < 3; i++)
        corners += nearest.barycentric[1][i] > 0;
    return corners;
}

static void draw_feet(fig_page *page, const fig_plot *plot, fig_point at)
{
    tf_nearest nearest = nearest_to(at);
    fig_point line[2] = {at, {0, 0}};
    for (int i = 0; i < 3; i++) {
        line[1].x += nearest.barycentric[1][i] * corner[(ptrdiff_t)3 * i];
        line[1].y += nearest.barycentric[1][i] * corner[3 * i + 1];
    }
    fig_plot_curve(
        page, plot, 2, line,
        (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL}, .dash = 2});
}

static void draw_around(fig_page *page, fig_box box, FILE *numbers)
{
    fig_plot plot = {.box = box,
                     .x = {-0.7, 2.9},
                     .y = {-0.75, -0.75 + 3.6 * box.height / box.width}};
    fig_point triangle[4];
    int pieces = 0;
    for (int i = 0; i < 4; i++)
        triangle[i] = (fig_point){corner[(ptrdiff_t)3 * (i % 3)],
                                  corner[3 * (i % 3) + 1]};
    fig_plot_curve(page, &plot, 4, triangle,
                   (fig_stroke){.paint = {.role = FIG_ROLE_TRIANGLE},
                                .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < AROUND; i++) {
        fig_point line[] = {point_around(i * 2 * pi / AROUND),
                            point_around((i + 1) * 2 * pi / AROUND)};
        bool edge = feature_of(line[0]) == 2;
        if (edge != (feature_of(line[1]) == 2)) {
            draw_feet(page, &plot, line[0]);
            pieces++;
        }
        fig_plot_curve(page, &plot, 2, line,
                       (fig_stroke){.paint = {.role = edge ? FIG_ROLE_EDGE
                                                           : FIG_ROLE_POINT},
                                    .width = FIG_WIDTH_TUBE});
    }
    fig_number(numbers, "pieces", pieces);
    fig_number(numbers, "length", length);
}

// Two curves ------------------------------------------------------------------

typedef struct curves {
    int edge[2 * CURVES * (POINTS - 1)];
    double start[2 * CURVES * POINTS], end[2 * CURVES * POINTS];
    double inverse_mass[CURVES * POINTS];
} curves;

static void make_curves(curves *made)
{
    for (int c = 0; c < CURVES; c++)
        for (int i = 0; i < POINTS; i++) {
            int v = c * POINTS + i;
            double x = 2.0 * i / (POINTS - 1) + 0.02 * c;
            double wave = 0.1 * cos(2 * pi * x);
            made->start[(ptrdiff_t)2 * v] = made->end[(ptrdiff_t)2 * v] = x;
            made->start[2 * v + 1] = wave + 0.22 * c;
            made->end[2 * v + 1] = wave + 0.05 * c;
            made->inverse_mass[v] = c;
            if (i == POINTS - 1)
                continue;
            made->edge[(ptrdiff_t)2 * (v - c)] = v;
            made->edge[2 * (v - c) + 1] = v + 1;
        }
}

/// The least distance of the curves at the end, at least.
static double resolve(curves *made, double wanted)
{
    tf_mesh mesh = {.axes = 2,
                    .vertices = CURVES * POINTS,
                    .edges = CURVES * (POINTS - 1),
                    .edge = made->edge};
    tf_surface *surface;
    tf_resolver *resolver;
    tf_response_options options = {.size = sizeof options, .thickness = wanted};
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_step_resolve(resolver, mesh.vertices, made->start, made->end,
                               made->inverse_mass, &options, NULL,
                               NULL) == TF_OK);
    double least = INFINITY;
    for (int v = 0; v < mesh.vertices; v++)
        for (int e = 0; e < mesh.edges; e++) {
            int vertex[] = {v, made->edge[(ptrdiff_t)2 * e],
                            made->edge[2 * e + 1]};
            tf_nearest nearest;
            if (vertex[1] / POINTS != v / POINTS &&
                tf_distance(TF_POINT_EDGE, mesh.vertices, made->end, vertex,
                            &nearest) == TF_OK)
                least = fmin(least, nearest.lower);
        }
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return least;
}

static void draw_curves(fig_page *page, fig_box box, double wanted,
                        const char *title, FILE *numbers, const char *key)
{
    fig_plot plot = {.box = box, .x = {-0.1, 2.12}};
    // The scale is the same on both axes, for the width of the bands.
    double scale = box.width / (plot.x[1] - plot.x[0]);
    plot.y[0] = -0.3;
    plot.y[1] = plot.y[0] + box.height / scale;
    curves made;
    make_curves(&made);
    fig_number(numbers, key, resolve(&made, wanted));
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    for (int c = 0; c < CURVES; c++) {
        fig_point at[POINTS];
        fig_role role = c == 0 ? FIG_ROLE_OTHER_EDGE : FIG_ROLE_EDGE;
        for (int i = 0; i < POINTS; i++)
            at[i] = (fig_point){made.end[(ptrdiff_t)2 * (c * POINTS + i)],
                                made.end[2 * (c * POINTS + i) + 1]};
        if (wanted > 0)
            fig_plot_curve(page, &plot, POINTS, at,
                           (fig_stroke){.paint = {.role = role, .opacity = 0.3},
                                        .width = wanted * scale});
        fig_plot_curve(
            page, &plot, POINTS, at,
            (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_LINE});
    }
    fig_page_title(page, box, title);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = fig_page_width(page);
    draw_around(page, (fig_box){4, 10, 0.5 * width - 12, 140}, numbers);
    double left = 0.5 * width + 4, panel = 0.5 * width - 12;
    draw_curves(page, (fig_box){left, 16, panel, 62}, 0, "no thickness",
                numbers, "least_without");
    draw_curves(page, (fig_box){left, 98, panel, 62}, thickness, "a thickness",
                numbers, "least_with");
    fig_number(numbers, "thickness", thickness);
}

const fig_figure fig_two_thicknesses = {
    .name = "two-thicknesses",
    .title = "What is at a distance",
    .width = FIG_PAGE_WIDTH,
    .height = 170,
    .draw = draw,
};
