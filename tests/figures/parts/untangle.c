// What the figures of untangling print.
#include "figures/numbers.h"

#include "kit/tangles.h"

#include <stddef.h>

static double volume(const double *a, const double *b, const double *c,
                     const double *d)
{
    double m[3][3];
    const double *to[] = {b, c, d};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[i][k] = to[i][k] - a[k];
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Whether an edge passes through a triangle, as far as rounding can tell.
static bool passes(const double *a, const double *b, const double *const t[3])
{
    double high = volume(a, t[0], t[1], t[2]),
           low = volume(b, t[0], t[1], t[2]);
    double part[3];
    for (int i = 0; i < 3; i++)
        part[i] = volume(a, b, t[i], t[(i + 1) % 3]);
    return high * low < 0 && part[0] * part[1] > 0 && part[1] * part[2] > 0;
}

/// How many sides of a triangle pass through another one.
static int sides_through(const fig_some_mesh *mesh, int s, int t)
{
    const int *u = mesh->triangle + 3 * (ptrdiff_t)s,
              *v = mesh->triangle + 3 * (ptrdiff_t)t;
    const double *corner[3];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        corner[i] = mesh->x + 3 * (ptrdiff_t)v[i];
        for (int k = 0; k < 3; k++)
            if (u[k] == v[i])
                return 0;
    }
    for (int i = 0; i < 3; i++)
        count += passes(mesh->x + 3 * (ptrdiff_t)u[i],
                        mesh->x + 3 * (ptrdiff_t)u[(i + 1) % 3], corner);
    return count;
}

/// The loop is closed, so that each edge has two triangles; it is bent, so that
/// rounding misleads nowhere; and no two of its edges meet.
static void loop_is_checked(void)
{
    fig_tangle tangle = fig_tangle_make("loop");
    int passed = 0;
    for (int s = 0; s < tangle.mesh.triangles; s++)
        for (int t = 0; t < tangle.mesh.triangles; t++)
            passed += sides_through(&tangle.mesh, s, t);
    expect(passed / 2., "crossings_4");
    fig_tangle_free(&tangle);
}

const figure_test untangle_tests[] = {{&fig_twelve_tangles, loop_is_checked},
                                      {NULL, NULL}};
