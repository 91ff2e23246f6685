#include "kit/meshes.h"

#include "base/require.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

static const double tau = 6.283185307179586;

static fig_some_mesh make(int vertices, int triangles)
{
    fig_some_mesh mesh = {
        .x = calloc(3 * (size_t)vertices, sizeof *mesh.x),
        .triangle = calloc(3 * (size_t)triangles, sizeof *mesh.triangle)};
    TF_REQUIRE(mesh.x && mesh.triangle);
    return mesh;
}

void fig_some_mesh_free(fig_some_mesh *mesh)
{
    free(mesh->x);
    free(mesh->triangle);
    *mesh = (fig_some_mesh){0};
}

tf_mesh fig_mesh_in_space(const fig_some_mesh *mesh)
{
    return (tf_mesh){.axes = 3,
                     .vertices = mesh->vertices,
                     .triangles = mesh->triangles,
                     .triangle = mesh->triangle};
}

static void add_vertex(fig_some_mesh *mesh, double x, double y, double z)
{
    double *at = mesh->x + 3 * (size_t)mesh->vertices++;
    at[0] = x;
    at[1] = y;
    at[2] = z;
}

static void add_triangle(fig_some_mesh *mesh, int a, int b, int c)
{
    int *at = mesh->triangle + 3 * (size_t)mesh->triangles++;
    at[0] = a;
    at[1] = b;
    at[2] = c;
}

// The disc ---------------------------------------------------------------

/// The i-th vertex of a ring, counted around it; ring 0 is the center.
static int ring_vertex(int ring, int i)
{
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring);
}

/// The sixth of the band between a ring and the one within.
static void add_sixth(fig_some_mesh *mesh, int ring, int sixth)
{
    int outer = sixth * ring, inner = sixth * (ring - 1);
    for (int i = 0; i < ring; i++) {
        add_triangle(mesh, ring_vertex(ring - 1, inner + i),
                     ring_vertex(ring, outer + i),
                     ring_vertex(ring, outer + i + 1));
        if (i + 1 < ring)
            add_triangle(mesh, ring_vertex(ring - 1, inner + i),
                         ring_vertex(ring, outer + i + 1),
                         ring_vertex(ring - 1, inner + i + 1));
    }
}

fig_some_mesh fig_disc(int rings, double height)
{
    fig_some_mesh mesh = make(1 + 3 * rings * (rings + 1), 6 * rings * rings);
    add_vertex(&mesh, 0, 0, 0);
    for (int ring = 1; ring <= rings; ring++) {
        double radius = (double)ring / rings;
        for (int i = 0; i < 6 * ring; i++) {
            double turn = tau * (i / (6.0 * ring) + 0.02);
            double x = radius * cos(turn), y = radius * sin(turn);
            add_vertex(&mesh, x, y, height * (x * x - y * y));
        }
        for (int sixth = 0; sixth < 6; sixth++)
            add_sixth(&mesh, ring, sixth);
    }
    return mesh;
}

// The folded sheet -------------------------------------------------------

/// Of the bend, and how far the sheet reaches from it to either side.
static const double bend_radius = 0.12, reach = 1.15;

/// A place across the fold, as far along the sheet as its flat end is at -1.
typedef struct profile {
    double x, z;   ///< the place
    double dx, dz; ///< the direction to the other end
} profile;

static profile profile_at(double s, double angle)
{
    // Flat up to 0, then around the bend, then straight.
    double bend = bend_radius * angle;
    if (s <= 0)
        return (profile){s, 0, 1, 0};
    double turn = fmin(s / bend, 1) * angle;
    profile at = {bend_radius * sin(turn), bend_radius * (1 - cos(turn)),
                  cos(turn), sin(turn)};
    at.x += fmax(s - bend, 0) * at.dx;
    at.z += fmax(s - bend, 0) * at.dz;
    return at;
}

static void add_folded_vertex(fig_some_mesh *mesh, double s, double y,
                              double angle)
{
    profile at = profile_at(s, angle);
    double free = fmax(s - bend_radius * angle, 0);
    double wave = 0.16 * free * sin(5.3 * y + 0.6) * sin(1.6 * free);
    add_vertex(mesh, at.x - wave * at.dz, y, at.z + wave * at.dx);
}

fig_some_mesh fig_folded_sheet(int rows, int columns, double angle)
{
    fig_some_mesh mesh = make((rows + 1) * (columns + 1), 2 * rows * columns);
    double turn = angle * tau / 360, bend = bend_radius * turn;
    for (int i = 0; i <= rows; i++)
        for (int j = 0; j <= columns; j++)
            add_folded_vertex(&mesh, -reach + (2 * reach + bend) * j / columns,
                              1.3 * i / rows - 0.65, turn);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            int a = i * (columns + 1) + j, b = a + 1;
            int c = a + columns + 1, d = c + 1;
            // Diagonals change sides from square to square.
            bool even = (i + j) % 2 == 0;
            add_triangle(&mesh, a, b, even ? c : d);
            add_triangle(&mesh, even ? b : a, d, c);
        }
    return mesh;
}
