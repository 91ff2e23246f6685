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
static int add_vertices(cloth_model *cloth, int count, double inverse_mass)
{
    int first = cloth->mesh.vertices, axes = cloth->mesh.axes;
    size_t size = sizeof(double) * (size_t)axes;
    cloth->position = extend(cloth->position, first, count, size);
    cloth->velocity = extend(cloth->velocity, first, count, size);
    cloth->inverse_mass =
        extend(cloth->inverse_mass, first, count, sizeof(double));
    memset(cloth->velocity + axes * first, 0, size * (size_t)count);
    for (int i = 0; i < count; i++)
        cloth->inverse_mass[first + i] = inverse_mass;
    cloth->mesh.vertices += count;
    return first;
}

static void add_triangle(cloth_model *cloth, int a, int b, int c)
{
    int *triangle =
        extend(cloth->mesh.triangle, cloth->mesh.triangles, 1, 3 * sizeof(int));
    memcpy(triangle + 3 * cloth->mesh.triangles, (const int[]){a, b, c},
           3 * sizeof(int));
    cloth->mesh.triangle = triangle;
    cloth->mesh.triangles++;
}

static void add_edge(cloth_model *cloth, int a, int b)
{
    int *edge = extend(cloth->mesh.edge, cloth->mesh.edges, 1, 2 * sizeof(int));
    memcpy(edge + 2 * cloth->mesh.edges, (const int[]){a, b}, 2 * sizeof(int));
    cloth->mesh.edge = edge;
    cloth->mesh.edges++;
}

static double distance(int axes, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < axes; k++)
        sum += (b[k] - a[k]) * (b[k] - a[k]);
    return sqrt(sum);
}

/// As long as it is.
static void add_spring(cloth_model *cloth, int a, int b, double stiffness)
{
    int axes = cloth->mesh.axes;
    cloth->spring =
        extend(cloth->spring, cloth->springs, 1, sizeof *cloth->spring);
    cloth->spring[cloth->springs++] = (spring){
        {a, b},
        distance(axes, cloth->position + axes * a, cloth->position + axes * b),
        stiffness};
}

/// A grid of squares, two triangles each.
typedef struct grid {
    int across, along; ///< squares
    double corner[3], step[2][3];
    bool elastic; ///< else it is at rest
} grid;

static void place_grid(cloth_model *cloth, const grid *g, int first)
{
    double *x = cloth->position + 3 * first;
    for (int j = 0; j <= g->along; j++)
        for (int i = 0; i <= g->across; i++, x += 3)
            for (int k = 0; k < 3; k++)
                x[k] = g->corner[k] + i * g->step[0][k] + j * g->step[1][k];
}

/// Along the edges and across the squares, and softer ones against bending.
static void add_grid_springs(cloth_model *cloth, const grid *g, int first)
{
    int row = g->across + 1;
    for (int j = 0; j <= g->along; j++)
        for (int i = 0; i <= g->across; i++) {
            int v = first + j * row + i;
            if (i < g->across)
                add_spring(cloth, v, v + 1, 0.9);
            if (j < g->along)
                add_spring(cloth, v, v + row, 0.9);
            if (i < g->across && j < g->along) {
                add_spring(cloth, v, v + row + 1, 0.5);
                add_spring(cloth, v + 1, v + row, 0.5);
            }
            if (i + 1 < g->across)
                add_spring(cloth, v, v + 2, 0.02);
            if (j + 1 < g->along)
                add_spring(cloth, v, v + 2 * row, 0.02);
        }
}

/// Returns its first vertex.
static int add_grid(cloth_model *cloth, const grid *g)
{
    int row = g->across + 1;
    int first = add_vertices(cloth, row * (g->along + 1), g->elastic);
    place_grid(cloth, g, first);
    for (int j = 0; j < g->along; j++)
        for (int i = 0; i < g->across; i++) {
            int v = first + j * row + i;
            add_triangle(cloth, v, v + 1, v + row + 1);
            add_triangle(cloth, v, v + row + 1, v + row);
        }
    if (g->elastic)
        add_grid_springs(cloth, g, first);
    return first;
}

/// A horizontal square about the vertical axis, turned about it.
static void add_square(cloth_model *cloth, int n, double edge, double height,
                       double turn, bool elastic)
{
    double c = edge * cos(turn), s = edge * sin(turn), half = 0.5 * n;
    add_grid(cloth, &(grid){n,
                            n,
                            {half * (s - c), -half * (s + c), height},
                            {{c, s, 0}, {-s, c, 0}},
                            elastic});
}

/// At rest about the origin.
static void add_ball(cloth_model *cloth, int rings, double radius)
{
    const double pi = 3.141592653589793;
    int sectors = 2 * rings;
    int first = add_vertices(cloth, (rings - 1) * sectors + 2, 0);
    int bottom = first + (rings - 1) * sectors, top = bottom + 1;
    for (int r = 1; r < rings; r++)
        for (int s = 0; s < sectors; s++) {
            int v = first + (r - 1) * sectors + s;
            int next = first + (r - 1) * sectors + (s + 1) % sectors;
            double *x = cloth->position + 3 * v, up = pi * r / rings;
            x[0] = radius * sin(up) * cos(pi * s / rings);
            x[1] = radius * sin(up) * sin(pi * s / rings);
            x[2] = -radius * cos(up);
            if (r == 1)
                add_triangle(cloth, bottom, next, v);
            if (r + 1 < rings) {
                add_triangle(cloth, v, next, next + sectors);
                add_triangle(cloth, v, next + sectors, v + sectors);
            } else {
                add_triangle(cloth, top, v, next);
            }
        }
    const double poles[] = {0, 0, -radius, 0, 0, radius};
    memcpy(cloth->position + 3 * bottom, poles, sizeof poles);
}

// Scenes ----------------------------------------------------------------------

static void make_chain(cloth_model *cloth, int n)
{
    int first = add_vertices(cloth, n + 1, 1),
        floor = add_vertices(cloth, 2, 0);
    for (int i = 0; i <= n; i++) {
        double *x = cloth->position + 2 * (first + i);
        x[0] = 0.2 * sin(0.7 * i);
        x[1] = 0.9 * i;
    }
    const double ends[] = {-2.0 * n, -1, 2.0 * n, -1.1};
    memcpy(cloth->position + 2 * floor, ends, sizeof ends);
    add_edge(cloth, floor, floor + 1);
    for (int i = 0; i < n; i++) {
        add_edge(cloth, first + i, first + i + 1);
        add_spring(cloth, first + i, first + i + 1, 0.9);
        if (i + 1 < n)
            add_spring(cloth, first + i, first + i + 2, 0.05);
    }
}

static void make_sphere(cloth_model *cloth, int n)
{
    double radius = 0.2 * n;
    add_square(cloth, n, 1, radius + 0.3, 0.3, true);
    add_ball(cloth, n / 3 + 3, radius);
    add_square(cloth, 1, 4 * n, -1.2 * radius, 0, false);
}

static void make_stack(cloth_model *cloth, int n, double turn)
{
    double radius = 0.25 * n;
    for (int i = 0; i < SHEETS; i++)
        add_square(cloth, n, 1, radius + 0.4 * (i + 1), turn * i, true);
    add_ball(cloth, n / 3 + 3, radius);
}

/// Scripted at both ends.
static void make_strip(cloth_model *cloth, int n, int length, double turn)
{
    int first = add_grid(
        cloth,
        &(grid){n, length, {0, -0.5 * n, 0}, {{0, 1, 0}, {1, 0, 0}}, true});
    for (int i = 0; i <= n; i++) {
        cloth->inverse_mass[first + i] = 0;
        cloth->inverse_mass[first + length * (n + 1) + i] = 0;
    }
    cloth->turn = turn;
    for (int v = 0; v < cloth->mesh.vertices; v++)
        cloth->position[3 * v] -= 0.5 * length;
}

cloth_model *cloth_new(cloth_scene scene, int n)
{
    cloth_model *cloth = calloc(1, sizeof *cloth);
    if (!cloth)
        abort();
    cloth->mesh.axes = scene == CHAIN ? 2 : 3;
    switch (scene) {
    case CHAIN:
        make_chain(cloth, n);
        break;
    case SPHERE:
        make_sphere(cloth, n);
        break;
    case STACK_ALIGNED:
        make_stack(cloth, n, 0);
        break;
    case STACK_TURNED:
        make_stack(cloth, n, 0.2);
        break;
    case TWIST:
        make_strip(cloth, n, TWIST_LENGTH * n, 0.05);
        break;
    case NARROW_TWIST:
        make_strip(cloth, n, NARROW_LENGTH * n, 0.15);
        break;
    }
    return cloth;
}

void cloth_free(cloth_model *cloth)
{
    free((int *)cloth->mesh.triangle);
    free((int *)cloth->mesh.edge);
    free(cloth->position);
    free(cloth->velocity);
    free(cloth->inverse_mass);
    free(cloth->spring);
    free(cloth);
}

// Steps -----------------------------------------------------------------------

static void turn_vertex(double angle, double x[3])
{
    double c = cos(angle), s = sin(angle), y = x[1];
    x[1] = c * y - s * x[2];
    x[2] = s * y + c * x[2];
}

/// Without springs: scripted vertices turn, the others fly on.
static void fly(const cloth_model *cloth, int v, double x[])
{
    int axes = cloth->mesh.axes;
    if (cloth->inverse_mass[v] > 0) {
        for (int k = 0; k < axes; k++)
            x[k] += cloth->velocity[axes * v + k];
        if (cloth->turn == 0)
            x[axes - 1] -= gravity;
    } else if (cloth->turn != 0) {
        turn_vertex(x[0] > 0 ? cloth->turn : -cloth->turn, x);
    }
}

static void relax(const cloth_model *cloth, const spring *s, double position[])
{
    int axes = cloth->mesh.axes;
    double *a = position + axes * s->vertex[0];
    double *b = position + axes * s->vertex[1];
    double of_a = cloth->inverse_mass[s->vertex[0]];
    double of_b = cloth->inverse_mass[s->vertex[1]];
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

void cloth_propose(const cloth_model *cloth, double end[])
{
    int axes = cloth->mesh.axes;
    memcpy(end, cloth->position,
           sizeof *end * (size_t)(axes * cloth->mesh.vertices));
    for (int v = 0; v < cloth->mesh.vertices; v++)
        fly(cloth, v, end + axes * v);
    for (int visit = 0; visit < VISITS; visit++)
        for (int i = 0; i < cloth->springs; i++)
            relax(cloth, &cloth->spring[i], end);
}

void cloth_accept(cloth_model *cloth, const double unpushed[],
                  const double end[])
{
    for (int i = 0; i < cloth->mesh.axes * cloth->mesh.vertices; i++) {
        cloth->velocity[i] = damping * (unpushed[i] - cloth->position[i]);
        cloth->position[i] = end[i];
    }
}
