// An edge of a sphere that is split on the level, and at the butterfly point,
// after which the vertices around it give the volume back.
#include "base/require.h"
#include "kit/figures.h"

#include "flow/butterfly.h"
#include "flow/patch.h"
#include "renderer/plot.h"
#include "surgery/move.h"
#include "surgery/split.h"
#include "surgery/star.h"

#include <math.h>

enum {
    HALF = 5, ///< rows of the lattice on either side of its middle
    ROW = 2 * HALF + 1,
    AROUND = 4,
    WAYS = 2
};

/// Of the sphere, in edges: large, so that it is nearly a paraboloid.
static const double radius = 1000;

/// By how much a flat triangle is below the sphere, on the average.
static double sagitta(void)
{
    return 1 / (8 * radius);
}

// The surface -----------------------------------------------------------------

static int at_row(int i, int j)
{
    return (j + HALF) * ROW + i + HALF;
}

/// A regular lattice of triangles on a paraboloid, raised by a sagitta.
static tf_adaptive_surface *make_lattice(void)
{
    static double x[ROW * ROW][3];
    static int triangle[6 * (ROW - 1) * (ROW - 1)];
    int *next = triangle;
    for (int j = -HALF; j <= HALF; j++)
        for (int i = -HALF; i <= HALF; i++) {
            double *at = x[at_row(i, j)];
            at[0] = i + j / 2.0;
            at[1] = j * sqrt(3) / 2;
            at[2] = sagitta() - (at[0] * at[0] + at[1] * at[1]) / (2 * radius);
        }
    for (int j = -HALF; j < HALF; j++)
        for (int i = -HALF; i < HALF; i++) {
            int a = at_row(i, j), b = at_row(i + 1, j);
            int c = at_row(i, j + 1), d = at_row(i + 1, j + 1);
            const int two[] = {a, b, c, b, d, c};
            for (int k = 0; k < 6; k++)
                *next++ = two[k];
        }
    tf_mesh mesh = {.axes = 3,
                    .vertices = ROW * ROW,
                    .triangles = 2 * (ROW - 1) * (ROW - 1),
                    .triangle = triangle};
    tf_adaptive_surface *surface = NULL;
    TF_REQUIRE(tf_adaptive_create(&mesh, &x[0][0], &surface, NULL) == TF_OK);
    return surface;
}

/// How far a vertex is above the paraboloid, in sagittas.
static double height_of(const tf_adaptive_surface *surface, int vertex)
{
    tf_vector at = tf_position_of(surface, vertex);
    double square = at.x[0] * at.x[0] + at.x[1] * at.x[1];
    return (at.x[2] + square / (2 * radius)) / sagitta();
}

// Splitting -------------------------------------------------------------------

/// The edge in the middle, and the vertices across from it.
static void find_around(int vertex[AROUND])
{
    vertex[0] = at_row(0, 0);
    vertex[1] = at_row(1, 0);
    vertex[2] = at_row(0, 1);
    vertex[3] = at_row(1, -1);
}

static void restore(tf_adaptive_surface *surface, double more,
                    const int vertex[AROUND])
{
    for (int i = 0; i < AROUND; i++) {
        tf_patch star = tf_patch_of_star(surface, vertex[i],
                                         tf_position_of(surface, vertex[i]));
        tf_vector position = tf_patch_position(&star, more / AROUND);
        tf_outcome outcome;
        TF_REQUIRE(tf_adaptive_move(surface, vertex[i], position.x, &outcome) ==
                       TF_OK &&
                   outcome == TF_COMMITTED);
    }
}

/// Returns the new vertex.
static int split(tf_adaptive_surface *surface, bool on_level,
                 const int around[AROUND])
{
    int forth = tf_find_edge(surface, around[0], around[1]);
    int back = tf_find_edge(surface, around[1], around[0]);
    TF_REQUIRE(forth != TF_NONE && back != TF_NONE);
    tf_shape own = tf_shape_of(surface, forth / 3);
    tf_shape other = tf_shape_of(surface, back / 3);
    tf_patch patch = {.apex = tf_butterfly_point(surface, forth)};
    tf_patch_add(&patch, &own);
    tf_patch_add(&patch, &other);
    tf_vector position = on_level ? tf_patch_position(&patch, 0) : patch.apex;
    int vertex;
    tf_outcome outcome;
    TF_REQUIRE(tf_adaptive_split(surface, around[0], around[1], position.x,
                                 &vertex, &outcome) == TF_OK &&
               outcome == TF_COMMITTED);
    if (!on_level)
        restore(surface, patch.below, around);
    return vertex;
}

// Drawing ---------------------------------------------------------------------

static void draw_heights(fig_page *page, const tf_adaptive_surface *surface,
                         int way, int vertex)
{
    fig_plot plot = {.box = {46 + 186.0 * way, 20, 140, 84},
                     .x = {-2.3, 3.3},
                     .y = {-0.2, 1.3},
                     .ticks_y = 3,
                     .name_x = "along the edge, $L$",
                     .name_y = way == 0 ? "height, $h$" : NULL};
    fig_plot_frame(page, &plot);
    fig_plot_level(page, &plot, 0);
    const int along[] = {at_row(-2, 0), at_row(-1, 0), at_row(0, 0), vertex,
                         at_row(1, 0),  at_row(2, 0),  at_row(3, 0)};
    enum {
        COUNT = sizeof along / sizeof *along
    };
    fig_point at[COUNT];
    for (int i = 0; i < COUNT; i++)
        at[i] = (fig_point){tf_position_of(surface, along[i]).x[0],
                            height_of(surface, along[i])};
    fig_plot_curve(page, &plot, COUNT, at,
                   (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    for (int i = 0; i < COUNT; i++)
        fig_plot_dot(page, &plot, at[i].x, at[i].y, 5,
                     along[i] == vertex ? FIG_ROLE_POINT : FIG_ROLE_EDGE);
    fig_page_title(page, plot.box, way == 0 ? "on the level" : "given back");
}

static void print_around(FILE *numbers, const tf_adaptive_surface *surface,
                         const int around[AROUND])
{
    double lowest = INFINITY, highest = -INFINITY;
    for (int i = 0; i < AROUND; i++) {
        lowest = fmin(lowest, height_of(surface, around[i]));
        highest = fmax(highest, height_of(surface, around[i]));
    }
    fig_number(numbers, "lowest", lowest);
    fig_number(numbers, "highest", highest);
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const keys[WAYS] = {"level", "butterfly"};
    int around[AROUND];
    find_around(around);
    for (int way = 0; way < WAYS; way++) {
        tf_adaptive_surface *surface = make_lattice();
        int vertex = split(surface, way == 0, around);
        draw_heights(page, surface, way, vertex);
        fig_number(numbers, keys[way], height_of(surface, vertex));
        if (way == 1)
            print_around(numbers, surface, around);
        tf_adaptive_free(surface);
    }
}

const fig_figure fig_split_heights = {
    .name = "split-heights",
    .title = "The heights of vertices after two kinds of splits",
    .width = FIG_PAGE_WIDTH,
    .height = 144,
    .draw = draw,
};
