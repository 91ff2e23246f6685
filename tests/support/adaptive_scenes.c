#include "support/adaptive_scenes.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

tf_mesh adaptive_scene_mesh(const adaptive_scene *scene)
{
    return (tf_mesh){.axes = 3,
                     .vertices = scene->vertices,
                     .triangles = scene->triangles,
                     .triangle = scene->triangle};
}

// Adding ----------------------------------------------------------------------

static int add_vertex(adaptive_scene *to, double x, double y, double z)
{
    const double position[] = {x, y, z};
    if (to->vertices == PLACED_VERTICES)
        abort();
    memcpy(to->position + 3 * to->vertices, position, sizeof position);
    to->part[to->vertices] = to->parts;
    return to->vertices++;
}

static void add_triangle(adaptive_scene *to, int a, int b, int c)
{
    const int vertex[] = {a, b, c};
    if (to->triangles == PLACED_TRIANGLES)
        abort();
    memcpy(to->triangle + 3 * to->triangles++, vertex, sizeof vertex);
}

static void add_square(adaptive_scene *to, int a, int b, int c, int d)
{
    add_triangle(to, a, b, c);
    add_triangle(to, a, c, d);
}

static double volume(const double corner[4][3])
{
    double u[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            u[i][k] = corner[i + 1][k] - corner[0][k];
    return u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
           u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
           u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0]);
}

void add_tetrahedron(adaptive_scene *to, const double corner[4][3])
{
    int v = to->vertices, swap = volume(corner) < 0;
    for (int i = 0; i < 4; i++)
        add_vertex(to, corner[i][0], corner[i][1], corner[i][2]);
    int b = swap ? v + 2 : v + 1, c = swap ? v + 1 : v + 2;
    add_triangle(to, v, c, b);
    add_triangle(to, v, b, v + 3);
    add_triangle(to, b, c, v + 3);
    add_triangle(to, c, v, v + 3);
    to->parts++;
}

/// The vertex at a place of this part, added if there is none.
static int vertex_at(adaptive_scene *to, double x, double y, double z)
{
    const double *p = to->position;
    for (int v = 0; v < to->vertices; v++)
        if (to->part[v] == to->parts && p[3 * v] == x && p[3 * v + 1] == y &&
            p[3 * v + 2] == z)
            return v;
    return add_vertex(to, x, y, z);
}

/// A unit square of a box, seen from outside.
static void add_lattice_square(adaptive_scene *to, const int at[3], int axis,
                               bool high)
{
    static const int way[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    int v[4];
    for (int i = 0; i < 4; i++) {
        int position[3] = {at[0], at[1], at[2]};
        position[(axis + 1) % 3] += way[high ? i : 3 - i][0];
        position[(axis + 2) % 3] += way[high ? i : 3 - i][1];
        v[i] = vertex_at(to, position[0], position[1], position[2]);
    }
    add_square(to, v[0], v[1], v[2], v[3]);
}

void add_box(adaptive_scene *to, const int low[3], const int high[3])
{
    for (int axis = 0; axis < 3; axis++) {
        int u = (axis + 1) % 3, v = (axis + 2) % 3, at[3];
        for (at[u] = low[u]; at[u] < high[u]; at[u]++)
            for (at[v] = low[v]; at[v] < high[v]; at[v]++) {
                at[axis] = high[axis];
                add_lattice_square(to, at, axis, true);
                at[axis] = low[axis];
                add_lattice_square(to, at, axis, false);
            }
    }
    to->parts++;
}

void turn_part_over(adaptive_scene *scene)
{
    for (int t = 0; t < scene->triangles; t++) {
        int *v = scene->triangle + 3 * t, swap = v[1];
        if (scene->part[*v] != scene->parts - 1)
            continue;
        v[1] = v[2];
        v[2] = swap;
    }
}

void add_sheet(adaptive_scene *to, int x, int y, int z, int columns, int rows)
{
    for (int i = 0; i < columns; i++)
        for (int j = 0; j < rows; j++) {
            const int at[3] = {x + i, y + j, z};
            add_lattice_square(to, at, 2, true);
        }
    to->parts++;
}

// Spheres and tori ------------------------------------------------------------

static int vertex_on_sphere(adaptive_scene *to, double radius, double x,
                            double y, double z)
{
    double scale = radius / sqrt(x * x + y * y + z * z);
    return vertex_at(to, scale * x, scale * y, scale * z);
}

/// A side of an octahedron, divided into four.
static void add_octant(adaptive_scene *to, double radius, const double s[3])
{
    static const double at[6][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                    {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    static const int triangles[4][3] = {
        {0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    int v[6], swap = s[0] * s[1] * s[2] < 0;
    for (int i = 0; i < 6; i++)
        v[i] = vertex_on_sphere(to, radius, s[0] * at[i][0] + 0.0,
                                s[1] * at[i][1] + 0.0, s[2] * at[i][2] + 0.0);
    for (int i = 0; i < 4; i++) {
        const int *t = triangles[i];
        add_triangle(to, v[t[0]], v[t[swap ? 2 : 1]], v[t[swap ? 1 : 2]]);
    }
}

void add_sphere(adaptive_scene *to, double radius)
{
    for (int i = 0; i < 8; i++) {
        const double s[] = {i & 1 ? -1 : 1, i & 2 ? -1 : 1, i & 4 ? -1 : 1};
        add_octant(to, radius, s);
    }
    to->parts++;
}

enum {
    AROUND = 7, ///< squares of a torus, the long way
    ACROSS = 4  ///< and the short way
};

static int vertex_on_torus(int first, int i, int j)
{
    return first + i % AROUND * ACROSS + j % ACROSS;
}

/// Around the z axis, or linked with that one.
static void add_torus(adaptive_scene *to, double thickness, bool linked)
{
    int first = to->vertices;
    double turn = 2 * acos(-1);
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j < ACROSS; j++) {
            double a = turn * i / AROUND, b = turn * (j + 0.3) / ACROSS;
            double r = 1 + thickness * cos(b), z = thickness * sin(b);
            if (linked)
                add_vertex(to, 1 + r * cos(a), z, -r * sin(a));
            else
                add_vertex(to, r * cos(a), r * sin(a), z);
        }
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j < ACROSS; j++)
            add_square(to, vertex_on_torus(first, i, j),
                       vertex_on_torus(first, i + 1, j),
                       vertex_on_torus(first, i + 1, j + 1),
                       vertex_on_torus(first, i, j + 1));
    to->parts++;
}

// Scenes ----------------------------------------------------------------------

static void make_spheres(generator *random, adaptive_scene *made)
{
    static const double gaps[] = {0.02, 1e-4, 1e-9};
    double gap = gaps[below(random, 3)];
    made->unit = 0.7;
    for (int i = 0; i < 3; i++)
        add_sphere(made, 1 - gap * i);
}

/// Whether the scene is still embedded.
static bool is_good(const adaptive_scene *made)
{
    tf_mesh mesh = adaptive_scene_mesh(made);
    tf_adaptive_surface *surface = NULL;
    tf_status status =
        tf_adaptive_create(&mesh, made->position, &surface, NULL);
    tf_adaptive_free(surface);
    return status == TF_OK;
}

/// Adds tetrahedra where there is room, until there are so many parts.
static void add_dust(generator *random, adaptive_scene *made, int parts,
                     const double low[3], const double high[3])
{
    while (made->parts < parts) {
        double size = pow(10, uniform(random, -3, -0.3));
        double middle[3], corner[4][3];
        for (int k = 0; k < 3; k++)
            middle[k] = uniform(random, low[k], high[k]);
        for (int i = 0; i < 12; i++)
            corner[i / 3][i % 3] = middle[i % 3] + uniform(random, -size, size);
        int vertices = made->vertices, triangles = made->triangles;
        add_tetrahedron(made, (const double(*)[3])corner);
        if (is_good(made))
            continue;
        made->vertices = vertices;
        made->triangles = triangles;
        made->parts--;
    }
}

static void make_dust(generator *random, adaptive_scene *made)
{
    static const double low[] = {-1.1, -1.1, -1.1}, high[] = {1.1, 1.1, 1.1};
    made->unit = 0.7;
    add_sphere(made, 1);
    add_dust(random, made, 24, low, high);
}

static void make_slabs(generator *random, adaptive_scene *made)
{
    made->unit = 1;
    for (int z = 0; z < 6; z += 2) {
        int x = below(random, 3), y = below(random, 3);
        const int low[] = {x, y, z};
        const int high[] = {x + 2 + below(random, 2), y + 2, z + 1};
        add_box(made, low, high);
    }
}

static void make_sheets(generator *random, adaptive_scene *made)
{
    made->unit = 1;
    for (int z = 0; z < 4; z++)
        add_sheet(made, below(random, 2), below(random, 2), z,
                  1 + below(random, 3), 1 + below(random, 3));
}

/// Moves each vertex by up to a twentieth of an edge, or of half of them none.
static void shake(generator *random, adaptive_scene *scene)
{
    bool still = below(random, 2);
    for (int i = 0; i < 3 * scene->vertices && !still; i++)
        scene->position[i] += uniform(random, -0.05, 0.05);
}

static void make_facing(generator *random, adaptive_scene *made)
{
    static const double low[] = {0, 0, 0.9}, high[] = {2, 2, 2.1};
    made->unit = 1;
    for (int z = 0; z < 4; z += 2)
        add_box(made, (const int[]){0, 0, z}, (const int[]){2, 2, z + 1});
    if (below(random, 2)) {
        add_box(made, (const int[]){-1, -1, -1}, (const int[]){3, 3, 4});
        turn_part_over(made);
    }
    shake(random, made);
    add_dust(random, made, made->parts + below(random, 9), low, high);
}

void adaptive_scene_make(generator *random, adaptive_scene_kind kind,
                         adaptive_scene *made)
{
    *made = (adaptive_scene){.kind = kind};
    switch (kind) {
    case NESTED_SPHERES:
        make_spheres(random, made);
        return;
    case DUST:
        make_dust(random, made);
        return;
    case SLABS:
        make_slabs(random, made);
        return;
    case LINKED_TORI:
        made->unit = 0.5;
        for (int i = 0; i < 2; i++)
            add_torus(made, 0.3, i == 1);
        return;
    case FACING_BOXES:
        make_facing(random, made);
        return;
    default:
        make_sheets(random, made);
    }
}
