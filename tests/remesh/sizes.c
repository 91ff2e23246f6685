// Sizes that vary: they change slowly, and follow a distance.
#include "remesh/sizes.h"

#include "remesh/keep_shape.h"
#include "support/adaptive_surfaces.h"
#include "support/flows.h"
#include "support/remeshers.h"
#include "support/support.h"

#include <math.h>

static tf_sizes sizes;

/// The target at a vertex of the original.
static double at(int vertex)
{
    return ((const double *)sizes.target.data)[vertex];
}

static double distance_between(const tf_adaptive_surface *surface, int a, int b)
{
    const double *x = coordinates_of(surface, a);
    const double *y = coordinates_of(surface, b);
    return hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]);
}

/// Expects that no target can be longer: each is the shortest of what its
/// neighbors and its own wish allow.
static void expect_graded(const tf_remesher *remesher, const double wish[])
{
    const tf_adaptive_surface *surface = remesher->original.surface;
    for (int v = 0; v < surface->vertices; v++) {
        double least = fmin(wish[v], remesher->edge);
        for (int c = 0; c < 3 * surface->triangles; c++)
            for (int i = 1; i < 3; i++) {
                int other = tf_vertex_at(surface, c / 3 * 3 + (c + i) % 3);
                if (tf_vertex_at(surface, c) == v)
                    least = fmin(least,
                                 at(other) +
                                     distance_between(surface, v, other) / 2);
            }
        ck_assert_double_eq_tol(at(v), least, 1e-15);
    }
}

START_TEST(sizes_change_slowly)
{
    generator random = generator_new(1);
    for (long run = 0; run < cases(30); run++) {
        tf_remesher *remesher =
            remesher_begin(adaptive_sheet(7, 7), &tf_keep_shape, 2);
        double wish[64];
        sizes = (tf_sizes){0};
        for (int v = 0; v < 64; v++)
            wish[v] = exp(uniform(&random, -6, 1));
        ((tf_adaptive_surface *)remesher->original.surface)->scale = 1;
        ck_assert(tf_sizes_begin(&sizes, remesher, wish));
        ck_assert_ptr_eq(remesher->target, sizes.target.data);
        expect_graded(remesher, wish);
        tf_sizes_free(&sizes);
        remesher_end(remesher);
    }
}
END_TEST

// On a sphere of radius 1 the size for a distance is known.
START_TEST(curvature_gives_the_size)
{
    static const double center[] = {0, 0, 0};
    tf_remesher *remesher =
        remesher_begin(adaptive_sphere(20, center, 1), &tf_keep_shape, 2);
    sizes = (tf_sizes){0};
    ck_assert(tf_sizes_begin_for(&sizes, remesher, 0.01));
    for (int v = 0; v < remesher->original.surface->vertices; v++) {
        ck_assert_double_gt(at(v), 0.6 * sqrt(6 * 0.01));
        ck_assert_double_lt(at(v), 1.3 * sqrt(6 * 0.01));
    }
    tf_sizes_free(&sizes);
    remesher_end(remesher);
}
END_TEST

START_TEST(a_plane_has_the_greatest_size)
{
    tf_remesher *remesher =
        remesher_begin(adaptive_sheet(4, 4), &tf_keep_shape, 2);
    sizes = (tf_sizes){0};
    ck_assert(tf_sizes_begin_for(&sizes, remesher, 0.01));
    for (int v = 0; v < 25; v++)
        ck_assert_double_eq(at(v), 2);
    tf_sizes_free(&sizes);
    remesher_end(remesher);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/sizes");
    TCase *tcase = tcase_create("sizes");
    tcase_add_test(tcase, sizes_change_slowly);
    tcase_add_test(tcase, curvature_gives_the_size);
    tcase_add_test(tcase, a_plane_has_the_greatest_size);
    suite_add_tcase(suite, tcase);
    return suite;
}
