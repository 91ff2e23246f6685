// Any number of threads finds the same candidates, contacts and intersections,
// bit by bit.
#include "bench/layers.h"
#include "fast/detect.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "surface/candidates.h"
#include "surface/check.h"
#include "threads/threads.h"

#include <string.h>

/// What is tried.
static tf_mesh mesh;
static tf_motion motion;

/// What is found of a surface, in rows that it lends.
typedef struct rows {
    size_t count, size;
    const void *row;
} rows;

typedef rows find_function(tf_surface *surface, const tf_parallel *parallel);

static rows find_candidates(tf_surface *surface, const tf_parallel *parallel)
{
    tf_candidates found;
    ck_assert_int_eq(
        tf_surface_candidates(surface, &motion,
                              &(tf_detect_options){.parallel = parallel},
                              &found, NULL),
        TF_OK);
    return (rows){found.point_count + found.edge_count, sizeof *found.points,
                  found.points};
}

static rows find_contacts(tf_surface *surface, const tf_parallel *parallel)
{
    tf_detect_options detection = {.parallel = parallel};
    tf_contacts found;
    ck_assert_int_eq(
        tf_surface_detect(surface, &motion, &detection, &found, NULL), TF_OK);
    return (rows){found.count, sizeof *found.contact, found.contact};
}

static rows find_crossings(tf_surface *surface, const tf_parallel *parallel)
{
    tf_crossings found;
    ck_assert_int_eq(tf_surface_check(surface, motion.vertices, motion.end,
                                      &(tf_check_options){.parallel = parallel},
                                      &found, NULL),
                     TF_OK);
    return (rows){found.count, sizeof *found.crossing, found.crossing};
}

static find_function *const functions[] = {find_candidates, find_contacts,
                                           find_crossings};

static void expect_rows(rows expected, rows found)
{
    ck_assert_uint_eq(found.count, expected.count);
    ck_assert_mem_eq(found.row, expected.row, found.count * found.size);
}

static void compare(find_function *find)
{
    static int numbers[] = {1, 2, 3, 8};
    tf_surface *one = surface_of(&mesh), *several = surface_of(&mesh);
    rows expected = find(one, NULL);
    for (int i = 0; i < 4; i++) {
        tf_threads *threads;
        ck_assert_int_eq(tf_threads_create(numbers[i], &threads), TF_OK);
        tf_parallel backward = scrambled_workers(&numbers[i]);
        expect_rows(expected, find(several, tf_threads_parallel(threads)));
        expect_rows(expected, find(several, &backward));
        tf_threads_free(threads);
    }
    tf_surface_free(one);
    tf_surface_free(several);
}

START_TEST(any_number_of_threads_finds_the_same_rows)
{
    static surface_case given;
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < (int)cases(10); i++) {
        random_surface(&random, 2 + i % 2, SURFACE_ELEMENTS,
                       (placement)(i % PLACEMENTS), &given);
        mesh = given.mesh;
        motion = given.motion;
        compare(functions[_i]);
    }
}
END_TEST

/// The surfaces above are a task or two; this one is many.
START_TEST(any_number_of_threads_finds_the_same_rows_in_cloth)
{
    layers cloth = layers_new(15, 1, 1);
    mesh = cloth.mesh;
    motion = cloth.motion;
    compare(functions[_i]);
    layers_free(&cloth);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/surface_threads");
    TCase *tcase = tcase_create("threads");
    tcase_add_loop_test(tcase, any_number_of_threads_finds_the_same_rows, 0, 3);
    tcase_add_loop_test(
        tcase, any_number_of_threads_finds_the_same_rows_in_cloth, 0, 3);
    suite_add_tcase(suite, tcase);
    return suite;
}
