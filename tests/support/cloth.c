#include "support/cloth.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const double gravity = 0.02, damping = 0.98;

enum {
    VISITS = 12,
    SHEETS = 6,
    TWIST_LENGTH = 4,   // times its width
    NARROW_LENGTH = 12, // times its width
};

const char *const cloth_names[CLOTH_SCENES] = {"chain",         "sphere",
                                               "stack aligned", "stack turned",
                                               "twist",         "narrow twist"};

// Building --------------------------------------------------------------------

/// Makes room for `more` items after the first `count`.
static void *extend(const void *items, int count, int more, size_t size)
{
    void *longer = realloc((void *)items, (size_t)(count + more) * size);
    if (!longer)
        abort();
    return longer;
}

/// Adds vertices without a position; returns the first.
static int add_vertices(cloth *of, int count, double inverse_mass)
{
    int first = of->mesh.vertices, axes = of->mesh.axes;
    size_t size = sizeof(double) * (size_t)axes;
    of->position = extend(of->position, first, count, size);
    of->velocity = extend(of->velocity, first, count, size);
    of->inverse_mass = extend(of->inverse_mass, first, count, sizeof(double));
    memset(of->velocity + axes * first, 0, size * (size_t)count);
    for (int i = 0; i < count; i++)
        of->inverse_mass[first + i] = inverse_mass;
    of->mesh.vertices += count;
    return first;
}

static void add_triangle(cloth *of, int a, int b, int c)
{
    int *triangle =
        extend(of->mesh.triangle, of->mesh.triangles, 1, 3 * sizeof(int));
    memcpy(triangle + 3 * of->mesh.triangles, (const int[]){a, b, c},
           3 * sizeof(int));
    of->mesh.triangle = triangle;
    of->mesh.triangles++;
}

static void add_edge(cloth *of, int a, int b)
{
    int *edge = extend(of->mesh.edge, of->mesh.edges, 1, 2 * sizeof(int));
    memcpy(edge + 2 * of->mesh.edges, (const int[]){a, b}, 2 * sizeof(int));
    of->mesh.edge = edge;
    of->mesh.edges++;
}

static double distance(int axes, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < axes; k++)
        sum += (b[k] - a[k]) * (b[k] - a[k]);
    return sqrt(sum);
}

/// As long as it is.
static void add_spring(cloth *of, int a, int b, double stiffness)
{
    int axes = of->mesh.axes;
    of->spring = extend(of->spring, of->springs, 1, sizeof *of->spring);
    of->spring[of->springs++] = (spring){
        {a, b},
        distance(axes, of->position + axes * a, of->position + axes * b),
        stiffness};
}

/// A grid of squares, two triangles each.
typedef struct grid {
    int across, along; ///< squares
    double corner[3], step[2][3];
    bool elastic; ///< else it is at rest
} grid;

static void place_grid(cloth *of, const grid *g, int first)
{
    double *x = of->position + 3 * first;
    for (int j = 0; j <= g->along; j++)
        for (int i = 0; i <= g->across; i++, x += 3)
            for (int k = 0; k < 3; k++)
                x[k] = g->corner[k] + i * g->step[0][k] + j * g->step[1][k];
}

/// Along the edges and across the squares, and softer ones against bending.
static void add_grid_springs(cloth *of, const grid *g, int first)
{
    int row = g->across + 1;
    for (int j = 0; j <= g->along; j++)
        for (int i = 0; i <= g->across; i++) {
            int v = first + j * row + i;
            if (i < g->across)
                add_spring(of, v, v + 1, 0.9);
            if (j < g->along)
                add_spring(of, v, v + row, 0.9);
            if (i < g->across && j < g->along) {
                add_spring(of, v, v + row + 1, 0.5);
                add_spring(of, v + 1, v + row, 0.5);
            }
            if (i + 1 < g->across)
                add_spring(of, v, v + 2, 0.02);
            if (j + 1 < g->along)
                add_spring(of, v, v + 2 * row, 0.02);
        }
}

/// Returns its first vertex.
static int add_grid(cloth *of, const grid *g)
{
    int row = g->across + 1;
    int first = add_vertices(of, row * (g->along + 1), g->elastic);
    place_grid(of, g, first);
    for (int j = 0; j < g->along; j++)
        for (int i = 0; i < g->across; i++) {
            int v = first + j * row + i;
            add_triangle(of, v, v + 1, v + row + 1);
            add_triangle(of, v, v + row + 1, v + row);
        }
    if (g->elastic)
        add_grid_springs(of, g, first);
    return first;
}

/// A horizontal square about the vertical axis, turned about it.
static void add_square(cloth *of, int n, double edge, double height,
                       double turn, bool elastic)
{
    double c = edge * cos(turn), s = edge * sin(turn), half = 0.5 * n;
    add_grid(of, &(grid){n,
                         n,
                         {half * (s - c), -half * (s + c), height},
                         {{c, s, 0}, {-s, c, 0}},
                         elastic});
}

/// At rest about the origin.
static void add_ball(cloth *of, int rings, double radius)
{
    const double pi = 3.141592653589793;
    int sectors = 2 * rings;
    int first = add_vertices(of, (rings - 1) * sectors + 2, 0);
    int bottom = first + (rings - 1) * sectors, top = bottom + 1;
    for (int r = 1; r < rings; r++)
        for (int s = 0; s < sectors; s++) {
            int v = first + (r - 1) * sectors + s;
            int next = first + (r - 1) * sectors + (s + 1) % sectors;
            double *x = of->position + 3 * v, up = pi * r / rings;
            x[0] = radius * sin(up) * cos(pi * s / rings);
            x[1] = radius * sin(up) * sin(pi * s / rings);
            x[2] = -radius * cos(up);
            if (r == 1)
                add_triangle(of, bottom, next, v);
            if (r + 1 < rings) {
                add_triangle(of, v, next, next + sectors);
                add_triangle(of, v, next + sectors, v + sectors);
            } else {
                add_triangle(of, top, v, next);
            }
        }
    const double poles[] = {0, 0, -radius, 0, 0, radius};
    memcpy(of->position + 3 * bottom, poles, sizeof poles);
}

// Scenes ----------------------------------------------------------------------

static void make_chain(cloth *of, int n)
{
    int first = add_vertices(of, n + 1, 1), floor = add_vertices(of, 2, 0);
    for (int i = 0; i <= n; i++) {
        double *x = of->position + 2 * (first + i);
        x[0] = 0.2 * sin(0.7 * i);
        x[1] = 0.9 * i;
    }
    const double ends[] = {-2.0 * n, -1, 2.0 * n, -1.1};
    memcpy(of->position + 2 * floor, ends, sizeof ends);
    add_edge(of, floor, floor + 1);
    for (int i = 0; i < n; i++) {
        add_edge(of, first + i, first + i + 1);
        add_spring(of, first + i, first + i + 1, 0.9);
        if (i + 1 < n)
            add_spring(of, first + i, first + i + 2, 0.05);
    }
}

static void make_sphere(cloth *of, int n)
{
    double radius = 0.2 * n;
    add_square(of, n, 1, radius + 0.3, 0.3, true);
    add_ball(of, n / 3 + 3, radius);
    add_square(of, 1, 4 * n, -1.2 * radius, 0, false);
}

static void make_stack(cloth *of, int n, double turn)
{
    double radius = 0.25 * n;
    for (int i = 0; i < SHEETS; i++)
        add_square(of, n, 1, radius + 0.4 * (i + 1), turn * i, true);
    add_ball(of, n / 3 + 3, radius);
}

/// Scripted at both ends.
static void make_strip(cloth *of, int n, int length, double turn)
{
    int first = add_grid(
        of, &(grid){n, length, {0, -0.5 * n, 0}, {{0, 1, 0}, {1, 0, 0}}, true});
    for (int i = 0; i <= n; i++) {
        of->inverse_mass[first + i] = 0;
        of->inverse_mass[first + length * (n + 1) + i] = 0;
    }
    of->turn = turn;
    for (int v = 0; v < of->mesh.vertices; v++)
        of->position[3 * v] -= 0.5 * length;
}

cloth *cloth_new(cloth_scene scene, int n)
{
    cloth *of = calloc(1, sizeof *of);
    if (!of)
        abort();
    of->mesh.axes = scene == CHAIN ? 2 : 3;
    switch (scene) {
    case CHAIN:
        make_chain(of, n);
        break;
    case SPHERE:
        make_sphere(of, n);
        break;
    case STACK_ALIGNED:
        make_stack(of, n, 0);
        break;
    case STACK_TURNED:
        make_stack(of, n, 0.2);
        break;
    case TWIST:
        make_strip(of, n, TWIST_LENGTH * n, 0.05);
        break;
    case NARROW_TWIST:
        make_strip(of, n, NARROW_LENGTH * n, 0.15);
        break;
    }
    return of;
}

void cloth_free(cloth *of)
{
    free((int *)of->mesh.triangle);
    free((int *)of->mesh.edge);
    free(of->position);
    free(of->velocity);
    free(of->inverse_mass);
    free(of->spring);
    free(of);
}

// Steps -----------------------------------------------------------------------

static void turn_vertex(double angle, double x[3])
{
    double c = cos(angle), s = sin(angle), y = x[1];
    x[1] = c * y - s * x[2];
    x[2] = s * y + c * x[2];
}

/// Without springs: scripted vertices turn, the others fly on.
static void fly(const cloth *of, int v, double x[])
{
    int axes = of->mesh.axes;
    if (of->inverse_mass[v] > 0) {
        for (int k = 0; k < axes; k++)
            x[k] += of->velocity[axes * v + k];
        if (of->turn == 0)
            x[axes - 1] -= gravity;
    } else if (of->turn != 0) {
        turn_vertex(x[0] > 0 ? of->turn : -of->turn, x);
    }
}

static void relax(const cloth *of, const spring *s, double position[])
{
    int axes = of->mesh.axes;
    double *a = position + axes * s->vertex[0];
    double *b = position + axes * s->vertex[1];
    double of_a = of->inverse_mass[s->vertex[0]];
    double of_b = of->inverse_mass[s->vertex[1]];
    double length = distance(axes, a, b);
    if (of_a + of_b == 0 || length == 0)
        return;
    double part = s->stiffness * (1 - s->length / length) / (of_a + of_b);
    for (int k = 0; k < axes; k++) {
        double pull = part * (b[k] - a[k]);
        a[k] += of_a * pull;
        b[k] -= of_b * pull;
    }
}

void cloth_propose(const cloth *of, double end[])
{
    int axes = of->mesh.axes;
    memcpy(end, of->position, sizeof *end * (size_t)(axes * of->mesh.vertices));
    for (int v = 0; v < of->mesh.vertices; v++)
        fly(of, v, end + axes * v);
    for (int visit = 0; visit < VISITS; visit++)
        for (int i = 0; i < of->springs; i++)
            relax(of, &of->spring[i], end);
}

void cloth_accept(cloth *of, const double end[])
{
    for (int i = 0; i < of->mesh.axes * of->mesh.vertices; i++) {
        of->velocity[i] = damping * (end[i] - of->position[i]);
        of->position[i] = end[i];
    }
}
