// Detection finds the same rows, among the same pairs, with any narrow phase.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "bench/layers.h"
#include "fast/detect.h"
#include "fast/vectorized.h"
#include "support/pair_rules.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "threads/threads.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tf_arithmetic *const arithmetics[] = {&tf_exact, &tf_perturbed,
                                                   &tf_clamped, &tf_published};

enum {
    ARITHMETICS = sizeof arithmetics / sizeof *arithmetics
};

/// What a detection finds, in memory of its own.
typedef struct rows {
    tf_contacts found;
    tf_surface_contact *row;
} rows;

static rows find(tf_surface *surface, const tf_motion *motion,
                 const tf_arithmetic *arithmetic,
                 const tf_narrow_phase *narrow_phase)
{
    tf_threads *threads;
    ck_assert_int_eq(tf_threads_create(2, &threads), TF_OK);
    tf_detect_options detection = {.arithmetic = arithmetic,
                                   .narrow_phase = narrow_phase,
                                   .parallel = tf_threads_parallel(threads)};
    rows all;
    ck_assert_int_eq(
        tf_surface_detect(surface, motion, &detection, &all.found, NULL),
        TF_OK);
    size_t bytes = all.found.count * sizeof *all.row;
    all.row = malloc(bytes + 1);
    memcpy(all.row, all.found.contact, bytes);
    tf_threads_free(threads);
    return all;
}

static void compare(const tf_mesh *mesh, const tf_motion *motion,
                    const tf_pair_filter *filter)
{
    tf_surface *surface = surface_of(mesh);
    ck_assert_int_eq(tf_surface_set_filter(surface, filter, NULL), TF_OK);
    for (int i = 0; i < ARITHMETICS; i++) {
        rows expected = find(surface, motion, arithmetics[i], &tf_reference);
        rows by_vectors = find(surface, motion, arithmetics[i], &tf_vectorized);
        const tf_detect_statistics *a = &expected.found.statistics;
        const tf_detect_statistics *b = &by_vectors.found.statistics;
        ck_assert_uint_eq(a->candidates, b->candidates);
        ck_assert_uint_eq(a->by_axis, b->by_axis);
        ck_assert_uint_eq(a->by_filter + a->by_signs,
                          b->by_filter + b->by_signs);
        // Vectors may be certain of more pairs before exact signs are needed.
        if (arithmetics[i] == &tf_exact)
            ck_assert_uint_ge(b->by_filter, a->by_filter);
        else
            ck_assert_uint_eq(a->by_filter, b->by_filter);
        ck_assert_uint_eq(expected.found.count, by_vectors.found.count);
        ck_assert_mem_eq(expected.row, by_vectors.row,
                         expected.found.count * sizeof *expected.row);
        free(expected.row);
        free(by_vectors.row);
    }
    tf_surface_free(surface);
}

START_TEST(random_surfaces_have_the_same_contacts_by_vectors)
{
    static surface_case given;
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(10); i > 0; i--) {
        random_surface(&random, 2 + _i / PLACEMENTS, SURFACE_ELEMENTS / 4,
                       (placement)(_i % PLACEMENTS), &given);
        compare(&given.mesh, &given.motion, NULL);
        static pair_rule rule;
        pair_rule_make(&random, given.mesh.axes, given.mesh.vertices,
                       given.start, &rule);
        compare(&given.mesh, &given.motion, &rule.filter);
    }
}
END_TEST

START_TEST(cloth_has_the_same_contacts_by_vectors)
{
    layers crowded = layers_new(8, 1, 1);
    compare(&crowded.mesh, &crowded.motion, NULL);
    tf_motion rest = crowded.motion;
    rest.end = rest.start;
    compare(&crowded.mesh, &rest, NULL);
    layers_free(&crowded);
}
END_TEST

enum {
    SIDE = 12
};

/// A flat sheet of right triangles, turned by two angles.
static void place_sheet(const double angle[2], double x[])
{
    for (int i = 0; i < (SIDE + 1) * (SIDE + 1); i++) {
        double a = i % (SIDE + 1), b = i / (SIDE + 1);
        double u = cos(angle[0]) * a - sin(angle[0]) * b;
        x[3 * i] = cos(angle[1]) * u;
        x[3 * i + 1] = sin(angle[0]) * a + cos(angle[0]) * b;
        x[3 * i + 2] = sin(angle[1]) * u;
    }
}

static void list_triangles(int triangle[])
{
    for (int i = 0, t = 0; i < SIDE * SIDE; i++, t += 6) {
        int corner = i / SIDE * (SIDE + 1) + i % SIDE;
        const int both[] = {corner,     corner + 1,        corner + SIDE + 1,
                            corner + 1, corner + SIDE + 2, corner + SIDE + 1};
        memcpy(triangle + t, both, sizeof both);
    }
}

/// A sheet in which nearly all pairs are certain by vectors.
static void expect_no_signs(const tf_mesh *mesh, const tf_motion *motion)
{
    tf_surface *surface = surface_of(mesh);
    rows by_vectors = find(surface, motion, &tf_exact, &tf_vectorized);
    ck_assert_uint_eq(by_vectors.found.count, 0);
    ck_assert_uint_eq(by_vectors.found.statistics.by_signs, 0);
    free(by_vectors.row);
    tf_surface_free(surface);
}

START_TEST(flat_sheets_have_the_same_contacts_by_vectors)
{
    static int triangle[6 * SIDE * SIDE];
    static double start[3 * (SIDE + 1) * (SIDE + 1)],
        end[3 * (SIDE + 1) * (SIDE + 1)];
    generator random = generator_new(9);
    list_triangles(triangle);
    tf_mesh mesh = {.axes = 3,
                    .vertices = (SIDE + 1) * (SIDE + 1),
                    .triangles = 2 * SIDE * SIDE,
                    .triangle = triangle};
    for (long i = cases(20); i > 0; i--) {
        double angle[2] = {0, 0};
        for (int k = 0; k < 2 && i % 4 != 0; k++)
            angle[k] = uniform(&random, -4, 4);
        place_sheet(angle, start);
        if (i % 2)
            angle[0] += uniform(&random, -0.1, 0.1);
        place_sheet(angle, end);
        tf_motion motion = {3, mesh.vertices, start, end};
        compare(&mesh, &motion, NULL);
        expect_no_signs(&mesh, &motion);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/narrow_phases");
    TCase *c = tcase_create("narrow phases");
    tcase_add_loop_test(c, random_surfaces_have_the_same_contacts_by_vectors, 0,
                        2 * PLACEMENTS);
    tcase_add_test(c, cloth_has_the_same_contacts_by_vectors);
    tcase_add_test(c, flat_sheets_have_the_same_contacts_by_vectors);
    suite_add_tcase(suite, c);
    return suite;
}
