// Vertices at one position, or near each other.
#include "scenes/coincident.h"

#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/// What the definition says, by looking at all pairs.
static void find_all(int vertices, const double x[], double within, int first[])
{
    for (int v = 0; v < vertices; v++) {
        double nearest = INFINITY;
        first[v] = v;
        for (int u = 0; u < v; u++) {
            double distance = tf_distance_between(x + 3 * u, x + 3 * v);
            if (first[u] == u && distance <= within && distance < nearest) {
                nearest = distance;
                first[v] = u;
            }
        }
    }
}

static void expect_as_defined(int vertices, const double x[], double within)
{
    int *found = malloc(2 * (size_t)vertices * sizeof *found);
    int *right = found + vertices;
    ck_assert(tf_find_coincident(vertices, x, within, found));
    find_all(vertices, x, within, right);
    for (int v = 0; v < vertices; v++)
        ck_assert_msg(found[v] == right[v], "%d: %d, not %d, within %a", v,
                      found[v], right[v], within);
    free(found);
}

// Random positions ------------------------------------------------------------

enum {
    MOST = 60
};

/// Points of a small lattice, of which many coincide, moved, scaled and turned
/// into negative ones.
static int make_lattice(generator *random, double x[3 * MOST], double scale)
{
    int vertices = 1 + below(random, MOST), side = 2 + below(random, 6);
    double origin = below(random, 3) * 1.0 - 1;
    for (int i = 0; i < 3 * vertices; i++)
        x[i] = (below(random, side) - 2 + origin) * scale;
    return vertices;
}

START_TEST(equal_positions_are_found)
{
    generator random = generator_new(0xc01);
    double x[3 * MOST];
    for (long i = 0; i < cases(20000); i++)
        expect_as_defined(make_lattice(&random, x, 1), x, 0);
}
END_TEST

START_TEST(near_positions_are_found)
{
    static const double scales[] = {1, 1e-300, 1e300, 0.1, 1e10};
    generator random = generator_new(0xc02);
    double x[3 * MOST];
    for (long i = 0; i < cases(20000); i++) {
        double scale = scales[below(&random, 5)];
        int vertices = make_lattice(&random, x, scale);
        for (int k = 0; k < 3 * vertices && i % 2; k++)
            x[k] += scale * uniform(&random, -0.3, 0.3);
        // At lattice distances there are many ties.
        static const double within[] = {0.25, 1, 1.4142135623730951, 2, 0.01};
        expect_as_defined(vertices, x, scale * within[below(&random, 5)]);
        expect_as_defined(vertices, x, scale * uniform(&random, 0.1, 3));
    }
}
END_TEST

START_TEST(the_least_distance_is_enough)
{
    generator random = generator_new(0xc03);
    double x[3 * MOST];
    for (long i = 0; i < cases(20000); i++) {
        int vertices = 1 + below(&random, MOST);
        for (int k = 0; k < 3 * vertices; k++)
            x[k] = 1 + (below(&random, 40) - 20) * DBL_EPSILON;
        expect_as_defined(vertices, x, tf_least_within(vertices, x));
    }
}
END_TEST

// Single positions ------------------------------------------------------------

START_TEST(zeros_are_one_position)
{
    static const double x[] = {0, 0, 0, -0.0, 0, -0.0, 1, 1, 1};
    int first[3];
    ck_assert(tf_find_coincident(3, x, 0, first));
    ck_assert(first[0] == 0 && first[1] == 0 && first[2] == 2);
    ck_assert(tf_find_coincident(3, x, 0.5, first));
    ck_assert(first[0] == 0 && first[1] == 0 && first[2] == 2);
}
END_TEST

START_TEST(no_vertices_are_none)
{
    ck_assert(tf_find_coincident(0, NULL, 0, NULL));
    ck_assert(tf_least_within(0, NULL) == 0);
}
END_TEST

START_TEST(chains_do_not_grow)
{
    // Each is within 1 of the next, but only every other one is left.
    double x[30] = {0};
    int first[10];
    for (int v = 0; v < 10; v++)
        x[3 * v] = 0.75 * v;
    ck_assert(tf_find_coincident(10, x, 1, first));
    for (int v = 0; v < 10; v++)
        ck_assert_int_eq(first[v], v - v % 2);
}
END_TEST

START_TEST(distances_do_not_overflow)
{
    static const double x[] = {3e200, 0, 0}, y[] = {0, 4e200, 0},
                        z[] = {3e-200, 4e-200, 0}, none[3] = {0};
    ck_assert(fabs(tf_distance_between(x, y) / 5e200 - 1) < 1e-15);
    ck_assert(fabs(tf_distance_between(z, none) / 5e-200 - 1) < 1e-15);
    ck_assert(tf_least_within(1, y) == 0x1p-50 * 4e200);
    ck_assert(tf_least_within(1, (const double[]){0, -8, 1}) == 0x1p-47);
}
END_TEST

// Large meshes ----------------------------------------------------------------

static double seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

/// How long a flat sheet takes, in which each vertex is there twice.
static double time_sheet(int side, double within)
{
    int vertices = 2 * side * side;
    double *x = calloc(3 * (size_t)vertices, sizeof *x);
    int *first = malloc((size_t)vertices * sizeof *first);
    for (int v = 0; v < vertices; v++) {
        x[3 * v + 1] = v / 2 % side;
        x[3 * v + 2] = v / 2 / side + (v % 2) * within / 2;
    }
    double begin = seconds();
    ck_assert(tf_find_coincident(vertices, x, within, first));
    double end = seconds();
    for (int v = 0; v < vertices; v++)
        ck_assert_int_eq(first[v], v - v % 2);
    free(x);
    free(first);
    return end - begin;
}

START_TEST(the_time_is_not_quadratic)
{
    // 64 times as many would take 4096 times as long.
    for (int i = 0; i < 2; i++) {
        double small = time_sheet(40, i * 0.25),
               large = time_sheet(320, i * 0.25);
        ck_assert_msg(large < 0.5 + 1000 * small, "%g and %g s", small, large);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/coincident");
    TCase *random = tcase_create("random positions");
    tcase_add_test(random, equal_positions_are_found);
    tcase_add_test(random, near_positions_are_found);
    tcase_add_test(random, the_least_distance_is_enough);
    suite_add_tcase(suite, random);

    TCase *single = tcase_create("single positions");
    tcase_add_test(single, zeros_are_one_position);
    tcase_add_test(single, no_vertices_are_none);
    tcase_add_test(single, chains_do_not_grow);
    tcase_add_test(single, distances_do_not_overflow);
    suite_add_tcase(suite, single);

    TCase *large = tcase_create("large meshes");
    tcase_add_test(large, the_time_is_not_quadratic);
    suite_add_tcase(suite, large);
    return suite;
}
