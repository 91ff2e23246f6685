#include "shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Shapes ----------------------------------------------------------------------

static void add_vertex(shape *to, double x, double y, double z)
{
    double *place = to->position + (size_t)3 * (size_t)to->mesh.vertices++;
    place[0] = x;
    place[1] = y;
    place[2] = z;
}

static void add_triangle(shape *to, int a, int b, int c)
{
    int *corner = to->triangle + (size_t)3 * (size_t)to->mesh.triangles++;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

/// With an edge toward the next one, if `x` is that of the other side.
static void add_tetrahedron(shape *to, double x, double side)
{
    int a = to->mesh.vertices;
    add_vertex(to, x, -1, 0);
    add_vertex(to, x, 1, 0);
    add_vertex(to, x + 2 * side, 0, -1);
    add_vertex(to, x + 2 * side, 0, 1);
    int b = side > 0 ? a + 1 : a, c = side > 0 ? a : a + 1;
    add_triangle(to, b, c, a + 2);
    add_triangle(to, c, b, a + 3);
    add_triangle(to, c, a + 3, a + 2);
    add_triangle(to, b, a + 2, a + 3);
}

static void draw_tetrahedra(generator *random, shape *to)
{
    double gap = one_in(random, 2) ? 0.1 : uniform(random, 0.05, 1);
    add_tetrahedron(to, -gap, -1);
    if (!one_in(random, 3))
        add_tetrahedron(to, gap, 1);
}

/// Rings of three vertices, each joined to the next, and an end at each end.
static void draw_tube(generator *random, shape *to)
{
    int rings = 3 + below(random, 2);
    double waist = uniform(random, 0.1, 1);
    for (int ring = 0; ring < rings; ring++)
        for (int i = 0; i < 3; i++) {
            double radius = ring == 0 || ring == rings - 1 ? 1 : waist;
            add_vertex(to, radius * cos(2 * i), radius * sin(2 * i), ring);
        }
    for (int i = 0; i < 3 * (rings - 1); i++) {
        int after = i % 3 == 2 ? i - 2 : i + 1;
        add_triangle(to, i, after, after + 3);
        add_triangle(to, i, after + 3, i + 3);
    }
    int last = 3 * (rings - 1);
    add_triangle(to, 2, 1, 0);
    add_triangle(to, last, last + 1, last + 2);
}

/// Three by three squares, or fewer, in all heights.
static void draw_sheet(generator *random, shape *to)
{
    int side = 2 + below(random, 3);
    for (int i = 0; i < side * side; i++)
        add_vertex(to, i % side, i / side, uniform(random, 0, 0.4));
    for (int i = 0; i < side * (side - 1); i++)
        if (i % side < side - 1) {
            add_triangle(to, i, i + 1, i + side);
            add_triangle(to, i + 1, i + side + 1, i + side);
        }
}

static void draw_anything(generator *random, shape *to)
{
    to->mesh.vertices = 3 + below(random, 8);
    draw_coordinates(random, 3 * to->mesh.vertices, to->position);
    for (int i = 1 + below(random, 6); i > 0; i--) {
        int a = below(random, to->mesh.vertices);
        add_triangle(to, a, (a + 1) % to->mesh.vertices,
                     (a + 2) % to->mesh.vertices);
    }
}

/// Multiplies each axis by a power of two that loses no bit: of one axis less
/// than the others for slivers, of two for needles.
static void scale_shape(generator *random, shape *to)
{
    int all = below(random, 2000) - 1000, exponent[] = {all, all, all};
    for (int i = below(random, 3); i > 0; i--)
        exponent[below(random, 3)] = all - below(random, all + 1001);
    to->unit = ldexp(1, all);
    for (int i = 0; i < 3 * to->mesh.vertices; i++)
        to->position[i] = ldexp(to->position[i], exponent[i % 3]);
}

void shape_draw(generator *random, shape *drawn)
{
    static void (*const draw[])(generator *, shape *) = {
        draw_tetrahedra, draw_tube, draw_sheet, draw_anything};
    int kind = below(random, 4);
    *drawn = (shape){.mesh = {.axes = 3}, .embedded = kind < 3, .unit = 1};
    draw[kind](random, drawn);
    if (drawn->embedded && one_in(random, 4))
        scale_shape(random, drawn);
    drawn->mesh.triangle = drawn->triangle;
}

// States ----------------------------------------------------------------------

static void *copy(const void *from, size_t bytes)
{
    void *made = malloc(bytes + 1);
    if (!made)
        abort();
    if (bytes > 0)
        memcpy(made, from, bytes);
    return made;
}

static size_t index_bytes(const state *of)
{
    return 3 * sizeof *of->triangle * (size_t)of->mesh.triangles;
}

static size_t position_bytes(const state *of)
{
    return 3 * sizeof *of->position * (size_t)of->mesh.vertices;
}

state state_of(const tf_adaptive_surface *surface)
{
    state taken = {.mesh = *tf_adaptive_mesh(surface)};
    taken.triangle = copy(taken.mesh.triangle, index_bytes(&taken));
    taken.position =
        copy(tf_adaptive_positions(surface), position_bytes(&taken));
    taken.mesh.triangle = taken.triangle;
    return taken;
}

void state_free(state *of)
{
    free(of->triangle);
    free(of->position);
}

/// Of a triangle that is gone the first corner alone is said to be anything.
static bool triangles_equal(const state *a, const state *b)
{
    for (int i = 0; i < a->mesh.triangles; i++) {
        const int *own = a->triangle + (size_t)3 * (size_t)i;
        const int *other = b->triangle + (size_t)3 * (size_t)i;
        if (own[0] != other[0] ||
            (own[0] >= 0 && memcmp(own, other, 3 * sizeof *own) != 0))
            return false;
    }
    return true;
}

bool state_equals(const state *a, const state *b)
{
    return a->mesh.vertices == b->mesh.vertices &&
           a->mesh.triangles == b->mesh.triangles && triangles_equal(a, b) &&
           memcmp(a->position, b->position, position_bytes(a)) == 0;
}

tf_status state_copy(const state *of, tf_adaptive_surface **made)
{
    int *corner = copy(of->triangle, index_bytes(of));
    tf_mesh mesh = of->mesh;
    mesh.triangle = corner;
    mesh.triangles = 0;
    for (int i = 0; i < of->mesh.triangles; i++) {
        const int *own = of->triangle + (size_t)3 * (size_t)i;
        if (own[0] >= 0)
            memcpy(corner + (size_t)3 * (size_t)mesh.triangles++, own,
                   3 * sizeof *own);
    }
    tf_status status = tf_adaptive_create(&mesh, of->position, made, NULL);
    free(corner);
    return status;
}
