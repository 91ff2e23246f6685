// A cube that falls far into another in one step, resolved in one part and in
// many, from the side.
#include "base/memory.h"
#include "base/require.h"
#include "kit/figures.h"

#include "renderer/plot.h"
#include "response/resolve.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    FACES = 8, ///< along an edge of a cube
    CUBE = 6 * FACES * FACES + 2,
    VERTICES = 2 * CUBE,
    TRIANGLES = 2 * 12 * FACES * FACES,
    PARTS = 128,
    PANELS = 3
};

static const double gap = 0.3, fall = 1.2, aside[2] = {0.03, 0.018};

typedef struct cubes {
    int vertices, triangles;
    double start[VERTICES][3], proposed[VERTICES][3];
    double one[VERTICES][3], many[VERTICES][3]; ///< ends
    double inverse_mass[VERTICES];
    int triangle[TRIANGLES][3];
    int number[FACES + 1][FACES + 1][FACES + 1]; ///< and 1; 0: none yet
} cubes;

// The cubes -------------------------------------------------------------------

static int corner_of(cubes *c, const int at[3], const double from[3])
{
    int *number = &c->number[at[0]][at[1]][at[2]];
    if (*number == 0) {
        for (int k = 0; k < 3; k++)
            c->start[c->vertices][k] = from[k] + (double)at[k] / FACES;
        *number = ++c->vertices;
    }
    return *number - 1;
}

static void add_square(cubes *c, int axis, int side, int i, int j,
                       const double from[3])
{
    int corner[4];
    for (int n = 0; n < 4; n++) {
        int at[3];
        at[axis] = side * FACES;
        at[(axis + 1) % 3] = i + (n == 1 || n == 2);
        at[(axis + 2) % 3] = j + (n >= 2);
        corner[n] = corner_of(c, at, from);
    }
    for (int n = 1; n < 3; n++) {
        int *t = c->triangle[c->triangles++];
        t[0] = corner[0];
        t[1] = corner[n];
        t[2] = corner[n + 1];
    }
}

static void add_cube(cubes *c, const double from[3])
{
    memset(c->number, 0, sizeof c->number);
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < FACES; i++)
                for (int j = 0; j < FACES; j++)
                    add_square(c, axis, side, i, j, from);
}

static void make_cubes(cubes *c)
{
    add_cube(c, (double[]){0, 0, 0});
    add_cube(c, (double[]){aside[0], aside[1], 1 + gap});
    TF_REQUIRE(c->vertices == VERTICES && c->triangles == TRIANGLES);
    memcpy(c->proposed, c->start, sizeof c->start);
    for (int v = CUBE; v < VERTICES; v++) {
        c->inverse_mass[v] = 1;
        c->proposed[v][2] -= fall;
    }
}

static void resolve(const cubes *c, int parts, double end[][3])
{
    tf_mesh mesh = {.axes = 3,
                    .vertices = VERTICES,
                    .triangles = TRIANGLES,
                    .triangle = c->triangle[0]};
    tf_response_options options = {.size = sizeof options, .substeps = parts};
    tf_surface *surface;
    tf_resolver *resolver;
    memcpy(end, c->proposed, sizeof c->proposed);
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_step_resolve(resolver, VERTICES, c->start[0], end[0],
                               c->inverse_mass, &options, NULL, NULL) == TF_OK);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

/// How far a vertex ends from its path, which is upright, the most of all.
static double farthest_from_path(const cubes *c, double end[][3])
{
    double most = 0;
    for (int v = CUBE; v < VERTICES; v++) {
        double low = c->proposed[v][2], high = c->start[v][2];
        double beyond = fmax(fmax(low - end[v][2], end[v][2] - high), 0);
        double across =
            hypot(end[v][0] - c->start[v][0], end[v][1] - c->start[v][1]);
        most = fmax(most, hypot(across, beyond));
    }
    return most;
}

// Drawing ---------------------------------------------------------------------

static void draw_triangle(fig_page *page, const fig_plot *plot, const int t[3],
                          double x[][3], fig_role role)
{
    for (int k = 0; k < 3; k++) {
        const double *a = x[t[k]], *b = x[t[(k + 1) % 3]];
        fig_plot_curve(page, plot, 2, (fig_point[]){{a[0], a[2]}, {b[0], b[2]}},
                       (fig_stroke){.paint = {.role = role, .opacity = 0.45},
                                    .width = 0.5});
    }
}

static void draw_panel(fig_page *page, const cubes *c, double x[][3], int i,
                       const char *title)
{
    double width = fig_page_width(page) / PANELS;
    fig_plot plot = {.box = {width * i + 4, 18, width - 8, 172},
                     .x = {-0.5, 1.558},
                     .y = {-0.1, 2.85}};
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_page_title(page, plot.box, title);
    for (int t = 0; t < TRIANGLES; t++)
        draw_triangle(page, &plot, c->triangle[t], x,
                      c->triangle[t][0] < CUBE ? FIG_ROLE_NEUTRAL
                                               : FIG_ROLE_EDGE);
}

static void draw(fig_page *page, FILE *numbers)
{
    cubes *c = tf_allocate_zeroed(sizeof *c);
    TF_REQUIRE(c);
    make_cubes(c);
    resolve(c, 1, c->one);
    resolve(c, PARTS, c->many);
    draw_panel(page, c, c->start, 0, "the start");
    draw_panel(page, c, c->one, 1, "in one part");
    draw_panel(page, c, c->many, 2, "in many parts");
    fig_number(numbers, "parts", PARTS);
    fig_number(numbers, "edge", 1. / FACES);
    fig_number(numbers, "fall", fall);
    fig_number(numbers, "one", farthest_from_path(c, c->one));
    fig_number(numbers, "many", farthest_from_path(c, c->many));
    tf_release(c, sizeof *c);
}

const fig_figure fig_step_in_parts = {
    .name = "step-in-parts",
    .title = "A cube falls into another, in one part and in many",
    .width = FIG_PAGE_WIDTH,
    .height = 196,
    .draw = draw,
};
