#include "support/tangles.h"

#include "support/surface_of.h"

#include <check.h>
#include <string.h>

void tangle_begin(made_tangle *own, int axes)
{
    *own = (made_tangle){.mesh.axes = axes};
    own->mesh.triangle = own->triangle;
    own->mesh.edge = own->edge;
}

int tangle_add(made_tangle *own, int vertices, const double x[])
{
    int first = own->mesh.vertices;
    ck_assert_int_le(first + vertices, TANGLE_VERTICES);
    memcpy(own->x + (ptrdiff_t)own->mesh.axes * first, x,
           sizeof *x * (size_t)(own->mesh.axes * vertices));
    own->mesh.vertices += vertices;
    return first;
}

void tangle_add_triangle(made_tangle *own, int a, int b, int c)
{
    ck_assert_int_lt(own->mesh.triangles, TANGLE_ELEMENTS);
    int *to = own->triangle + 3 * (ptrdiff_t)own->mesh.triangles++;
    to[0] = a;
    to[1] = b;
    to[2] = c;
}

void tangle_add_edge(made_tangle *own, int a, int b)
{
    ck_assert_int_lt(own->mesh.edges, TANGLE_ELEMENTS);
    int *to = own->edge + 2 * (ptrdiff_t)own->mesh.edges++;
    to[0] = a;
    to[1] = b;
}

int tangle_add_sheet(made_tangle *own, int side, const double u[3],
                     const double v[3], const double from[3])
{
    int first = own->mesh.vertices;
    for (int i = 0; i < side * side; i++) {
        double place[3];
        for (int k = 0; k < 3; k++)
            place[k] = i / side * u[k] + i % side * v[k] + from[k];
        tangle_add(own, 1, place);
    }
    for (int i = 0; i < side * side; i++) {
        int a = first + i;
        if (i % side == side - 1 || i / side == side - 1)
            continue;
        tangle_add_triangle(own, a, a + 1, a + side);
        tangle_add_triangle(own, a + 1, a + side + 1, a + side);
    }
    return first;
}

void tangle_make_bump(made_tangle *own, double depth)
{
    tangle_begin(own, 3);
    tangle_add_sheet(own, 13, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){-6, -6, 0});
    int first =
        tangle_add_sheet(own, 13, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                         (double[]){-5.9, -5.8, 0.4});
    for (int i = first; i < own->mesh.vertices; i++) {
        double *x = own->x + 3 * (ptrdiff_t)i;
        x[2] -= depth / (1 + x[0] * x[0] + x[1] * x[1]);
    }
}

void tangle_finish(made_tangle *own)
{
    own->surface = surface_of(&own->mesh);
    own->tangle =
        (tf_tangle){.surface = own->surface, .fixed = own->fixed, .in = own->x};
    ck_assert(tf_tangle_begin(&own->tangle));
    tangle_check(own);
}

void tangle_check(made_tangle *own)
{
    ck_assert_int_eq(tf_tangle_check(&own->tangle, own->x), TF_OK);
}

void tangle_free(made_tangle *own)
{
    tf_tangle_end(&own->tangle);
    tf_surface_free(own->surface);
}
