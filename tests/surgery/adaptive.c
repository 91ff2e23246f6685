// What an adaptive surface keeps and lends.
#include "surgery/adaptive.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/collapse.h"

#include <signal.h>
#include <string.h>

START_TEST(a_surface_is_lent_as_it_was_given)
{
    static adaptive_scene scene;
    generator random = generator_new(1);
    adaptive_scene_make(&random, SLABS, &scene);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &surface, NULL),
                     TF_OK);
    tf_mesh lent = *tf_adaptive_mesh(surface);
    ck_assert_int_eq(lent.vertices, mesh.vertices);
    ck_assert_int_eq(lent.triangles, mesh.triangles);
    ck_assert_int_eq(lent.edges, 0);
    ck_assert_mem_eq(lent.triangle, mesh.triangle, 12 * (size_t)mesh.triangles);
    ck_assert_mem_eq(tf_adaptive_positions(surface), scene.position,
                     24 * (size_t)mesh.vertices);
    tf_adaptive_free(surface);
}
END_TEST

// A sheet of four squares, without a vertex and without another vertex that
// never had triangles.
START_TEST(compaction_keeps_the_order)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    tf_outcome outcome;
    int map[9];
    ck_assert_int_eq(tf_adaptive_collapse(surface, 4, 5, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_int_eq(tf_adaptive_compact(surface, map), TF_OK);
    for (int v = 0; v < 9; v++)
        ck_assert_int_eq(map[v], v == 4 ? -1 : v - (v > 4));
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    ck_assert_int_eq(mesh.vertices, 8);
    ck_assert_int_eq(mesh.triangles, 6);
    ck_assert_int_eq(triangles_of(surface), 6);
    ck_assert(has_triangle(surface, 0, 1, 4));
    ck_assert_double_eq(coordinates_of(surface, 7)[1], 2);

    // It works on, and nothing changes if there is no gap.
    ck_assert_int_eq(tf_adaptive_collapse(surface, 3, 0, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_int_eq(tf_adaptive_compact(surface, NULL), TF_OK);
    ck_assert_int_eq(tf_adaptive_compact(surface, map), TF_OK);
    for (int v = 0; v < 7; v++)
        ck_assert_int_eq(map[v], v);
    tf_adaptive_free(surface);
}
END_TEST

// Operations on a surface that hardly grows hardly need more memory: a number
// left behind by each would be more.
START_TEST(a_steady_state_allocates_no_memory)
{
    enum {
        TRIES = 12000
    };
    static surgery_run run;
    static surgery_counts counts;
    size_t bytes = 0;
    surgery_run_begin(&run, generator_new(3), SLABS, &counts);
    for (int i = 0; i < TRIES; i++) {
        if (i == TRIES / 4)
            bytes = tf_adaptive_memory(run.surface);
        surgery_choice request = surgery_run_choose(&run);
        operate(&run, &request);
        if (i % 100 == 0)
            surgery_run_compact(&run);
    }
    size_t leaked = 3 * TRIES / 4 * sizeof(int);
    ck_assert_uint_lt(tf_adaptive_memory(run.surface), bytes + leaked);
    surgery_run_end(&run);
}
END_TEST

START_TEST(null_may_be_freed)
{
    tf_adaptive_free(NULL);
}
END_TEST

START_TEST(a_surface_needs_positions)
{
    tf_mesh mesh = {.axes = 3};
    tf_adaptive_surface *surface;
    tf_adaptive_create(&mesh, NULL, &surface, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/adaptive");
    TCase *tcase = tcase_create("surface");
    tcase_add_test(tcase, a_surface_is_lent_as_it_was_given);
    tcase_add_test(tcase, compaction_keeps_the_order);
    tcase_add_test(tcase, a_steady_state_allocates_no_memory);
    tcase_add_test(tcase, null_may_be_freed);
    tcase_add_test_raise_signal(tcase, a_surface_needs_positions, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
