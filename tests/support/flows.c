#include "support/flows.h"

#include "support/adaptive_surfaces.h"
#include "support/generator.h"
#include "support/tangle.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

// Spheres ---------------------------------------------------------------------

enum {
    MOST_VERTICES = 10000
};

static double position[MOST_VERTICES][3];
static int triangle[6 * MOST_VERTICES], vertices, corners;

/// The number of a point of the octahedron |x| + |y| + |z| = n.
static int vertex_at(const int at[3])
{
    for (int v = vertices - 1; v >= 0; v--)
        if (position[v][0] == at[0] && position[v][1] == at[1] &&
            position[v][2] == at[2])
            return v;
    if (vertices == MOST_VERTICES)
        abort();
    for (int k = 0; k < 3; k++)
        position[vertices][k] = at[k];
    return vertices++;
}

/// Adds the triangle from (i, j) on in one of eight sides, to the right of the
/// diagonals or to the left.
static void add_cell(int n, int side, int i, int j, int half)
{
    const int at[3][2] = {{i + half, j + half}, {i + 1, j}, {i, j + 1}};
    int sign[3], turned = 0, vertex[3];
    for (int k = 0; k < 3; k++) {
        sign[k] = side >> k & 1 ? -1 : 1;
        turned ^= side >> k & 1;
    }
    for (int c = 0; c < 3; c++) {
        const int from[] = {sign[0] * (n - at[c][0] - at[c][1]),
                            sign[1] * at[c][0], sign[2] * at[c][1]};
        vertex[c] = vertex_at(from);
    }
    for (int c = 0; c < 3; c++)
        triangle[corners++] = vertex[(turned ^ half) && c ? 3 - c : c];
}

static void make_octahedron(int n)
{
    vertices = corners = 0;
    for (int side = 0; side < 8; side++)
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n - i; j++)
                for (int half = 0; half < 2 && half + i + j < n; half++)
                    add_cell(n, side, i, j, half);
}

/// Moves a vertex out from the origin to a distance.
static void stretch(double at[3], double distance)
{
    double length = hypot(hypot(at[0], at[1]), at[2]);
    for (int k = 0; k < 3; k++)
        at[k] *= distance / length;
}

tf_adaptive_surface *adaptive_sphere(int n, const double center[3],
                                     double radius)
{
    make_octahedron(n);
    for (int v = 0; v < vertices; v++) {
        stretch(position[v], radius);
        for (int k = 0; k < 3; k++)
            position[v][k] += center[k];
    }
    return adaptive_of(vertices, position, corners / 3, triangle);
}

tf_adaptive_surface *adaptive_bumpy_sphere(int n, double bump, uint64_t stream)
{
    generator random = generator_new(stream);
    make_octahedron(n);
    for (int v = 0; v < vertices; v++) {
        stretch(position[v], 1);
        for (int k = 0; k < 3; k++)
            position[v][k] += uniform(&random, -bump, bump);
    }
    return adaptive_of(vertices, position, corners / 3, triangle);
}

// Volumes ---------------------------------------------------------------------

/// volume += sign * a b c.
static void add_product(mpq_t volume, int sign, double a, double b, double c)
{
    mpq_t factor, product;
    mpq_init(factor);
    mpq_init(product);
    mpq_set_d(product, sign * a);
    mpq_set_d(factor, b);
    mpq_mul(product, product, factor);
    mpq_set_d(factor, c);
    mpq_mul(product, product, factor);
    mpq_add(volume, volume, product);
    mpq_clear(product);
    mpq_clear(factor);
}

void exact_volume(const tf_adaptive_surface *surface, mpq_t volume)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    const double *x = tf_adaptive_positions(surface);
    mpq_set_ui(volume, 0, 1);
    for (const int *v = mesh.triangle; v < mesh.triangle + 3 * mesh.triangles;
         v += 3)
        for (int k = 0; k < 3 && *v >= 0; k++) {
            const double *a = x + 3 * v[0], *b = x + 3 * v[1],
                         *c = x + 3 * v[2];
            int l = (k + 1) % 3, m = (k + 2) % 3;
            add_product(volume, 1, a[k], b[l], c[m]);
            add_product(volume, -1, a[k], b[m], c[l]);
        }
}

double volume_gained(const tf_adaptive_surface *surface, const mpq_t before)
{
    mpq_t now;
    mpq_init(now);
    exact_volume(surface, now);
    mpq_sub(now, now, before);
    double gained = mpq_get_d(now) / 6;
    mpq_clear(now);
    return gained;
}

// The judge -------------------------------------------------------------------

void expect_embedded(tf_adaptive_surface *surface)
{
    ck_assert_int_eq(tf_adaptive_compact(surface, NULL), TF_OK);
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    tangle_judge *judge = tangle_judge_new(&mesh);
    int count = tangle_count(judge, tf_adaptive_positions(surface));
    ck_assert_msg(count == 0, "%s", tangle_text(tangles(judge)));
    tangle_judge_free(judge);
}
