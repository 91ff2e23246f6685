#include "support/surfaces.h"

#include <math.h>
#include <stdbool.h>

// Elements --------------------------------------------------------------------

static void add_triangle(surface_case *made, int a, int b, int c)
{
    int *corner = made->triangle + 3 * made->mesh.triangles++;
    corner[0] = a, corner[1] = b, corner[2] = c;
}

static void add_edge(surface_case *made, int a, int b)
{
    int *corner = made->edge + 2 * made->mesh.edges++;
    corner[0] = a, corner[1] = b;
}

/// A vertex other than a and b.
static int another(generator *random, int vertices, int a, int b)
{
    int v;
    do
        v = below(random, vertices);
    while (v == a || v == b);
    return v;
}

/// Triangles of any three vertices, some of them twice.
static void add_soup(generator *random, int triangles, surface_case *made)
{
    int vertices = made->mesh.vertices;
    for (int i = 0; i < triangles; i++) {
        int a = below(random, vertices);
        int b = another(random, vertices, a, a);
        int c = another(random, vertices, a, b);
        add_triangle(made, a, b, c);
        if (below(random, 8) == 0 && i + 1 < triangles) {
            add_triangle(made, c, a, b);
            i++;
        }
    }
}

/// A strip of triangles, closed to a ring at times.
static void add_strip(generator *random, int triangles, surface_case *made)
{
    int vertices = made->mesh.vertices, first = below(random, vertices);
    for (int i = 0; i < triangles; i++)
        add_triangle(made, (first + i) % vertices, (first + i + 1) % vertices,
                     (first + i + 2) % vertices);
}

static void add_edges(generator *random, int edges, surface_case *made)
{
    int vertices = made->mesh.vertices, first = below(random, vertices);
    bool chain = below(random, 2) == 0;
    for (int i = 0; i < edges; i++) {
        int a = chain ? (first + i) % vertices : below(random, vertices);
        int b = chain ? (a + 1) % vertices : another(random, vertices, a, a);
        add_edge(made, a, b);
    }
}

// Places ----------------------------------------------------------------------

static double extreme(generator *random)
{
    static const int exponents[] = {-1074, -1060, -1022, -500, 0,
                                    500,   1000,  1020,  1022};
    int i = below(random, sizeof exponents / sizeof *exponents);
    return ldexp(uniform(random, -1, 1), exponents[i]);
}

static double place(generator *random, placement placed, int axis)
{
    switch (placed) {
    case ON_LATTICE:
        return below(random, 4);
    case IN_PLANE:
        return axis == 1 ? 1 : below(random, 5);
    case IN_POINT:
        return below(random, 12) == 0 ? below(random, 3) : 1;
    case HUGE_AND_TINY:
        return extreme(random);
    default:
        return uniform(random, -1, 1);
    }
}

/// Puts some vertices beside others along an axis, at the start and at the end:
/// at the same coordinate, or at the next on either side.
static void let_some_touch(generator *random, surface_case *made)
{
    int axes = made->mesh.axes;
    double *x[] = {made->start, made->end};
    for (int v = 1; v < made->mesh.vertices; v += 1 + below(random, 6)) {
        int k = below(random, axes), other = below(random, v);
        for (int end = 0; end < 2; end++) {
            double at = x[end][axes * other + k];
            int side = below(random, 3) - 1;
            x[end][axes * v + k] =
                side == 0 ? at : nextafter(at, side < 0 ? -INFINITY : INFINITY);
        }
    }
}

/// Ends of the step by one map of all starts, and a little besides at times; by
/// up to thousands of times the size of all.
static void move_together(generator *random, surface_case *made)
{
    int axes = made->mesh.axes;
    double scale = ldexp(1, below(random, 2001) - 1000), map[3][3], shift[3];
    double far = ldexp(1, below(random, 16)), turn = uniform(random, 0, 3);
    double noise = below(random, 2) ? uniform(random, 0, 0.2) : 0;
    for (int k = 0; k < axes; k++) {
        shift[k] = uniform(random, -far, far);
        for (int l = 0; l < axes; l++)
            map[k][l] = (k == l) + turn * uniform(random, -1, 1);
    }
    for (int v = 0; v < made->mesh.vertices; v++) {
        double *start = made->start + axes * v, *end = made->end + axes * v;
        for (int k = 0; k < axes; k++) {
            end[k] = shift[k] + uniform(random, -noise, noise);
            for (int l = 0; l < axes; l++)
                end[k] += map[k][l] * start[l];
        }
        for (int k = 0; k < axes; k++) {
            start[k] *= scale;
            end[k] *= scale;
        }
    }
}

static void place_vertices(generator *random, placement placed,
                           surface_case *made)
{
    int axes = made->mesh.axes;
    double reach = uniform(random, 0, 0.5);
    for (int i = 0; i < axes * made->mesh.vertices; i++) {
        made->start[i] = place(random, placed, i % axes);
        made->end[i] = placed == ANYWHERE
                           ? made->start[i] + uniform(random, -reach, reach)
                       : placed == AT_REST ? made->start[i]
                                           : place(random, placed, i % axes);
    }
    if (placed == TOGETHER) {
        move_together(random, made);
        let_some_touch(random, made);
    }
}

void random_surface(generator *random, int axes, int elements, placement placed,
                    surface_case *made)
{
    int count = 1 + below(random, elements);
    made->mesh = (tf_mesh){.axes = axes,
                           .vertices = 4 + below(random, 2 * elements - 1),
                           .triangle = made->triangle,
                           .edge = made->edge};
    if (made->mesh.vertices > SURFACE_VERTICES)
        made->mesh.vertices = SURFACE_VERTICES;
    int triangles = axes == 2 ? 0 : count;
    if (below(random, 2) == 0)
        add_soup(random, triangles, made);
    else
        add_strip(random, triangles, made);
    if (axes == 2 || below(random, 3) == 0)
        add_edges(random, 1 + below(random, count), made);
    place_vertices(random, placed, made);
    made->motion =
        (tf_motion){axes, made->mesh.vertices, made->start, made->end};
}
