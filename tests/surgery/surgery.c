// A surgery is described, tried, and done or not.
#include "surgery/surgery.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/outcome.h"
#include "surgery/star.h"
#include "surgery/trial.h"

#include <limits.h>

// A tetrahedron's corner 0 gets a roof: its three triangles become those of a
// vertex outside.
START_TEST(a_patch_replaces_a_patch)
{
    static const double position[] = {2, 2, 2};
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert(tf_surgery_begin(surface, 3));
    int added = tf_surgery_place(surface, position);
    ck_assert_int_eq(added, 4);
    int c = tf_first_corner(surface, 0);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_surgery_remove(surface, c / 3);
        tf_surgery_add(surface, added,
                       tf_vertex_at(surface, tf_corner_after(c)),
                       tf_vertex_at(surface, tf_corner_before(c)));
    }
    ck_assert_int_eq(tf_surgery_try(surface), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 4);
    ck_assert(has_triangle(surface, 0, 1, 2)); // nothing is changed yet
    tf_surgery_accept(surface);
    tf_surgery_commit(surface);
    ck_assert_int_eq(triangles_of(surface), 4);
    ck_assert(has_triangle(surface, 4, 1, 2));
    ck_assert_int_eq(tf_first_corner(surface, 0), TF_NONE);
    ck_assert_int_eq(tf_star_size(surface, 4), 3);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(only_boundary_edges_are_listed_as_kept)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    ck_assert(tf_surgery_begin(surface, 2));
    tf_surgery_keep(surface, tf_find_edge(surface, 0, 1));
    tf_surgery_keep(surface, tf_find_edge(surface, 1, 4));
    ck_assert_int_eq(surface->surgery.boundary_edges, 1);
    const int *edge = surface->surgery.boundary.data;
    ck_assert_int_eq(edge[0], 0);
    ck_assert_int_eq(edge[1], 1);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(too_many_triangles_are_refused)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert(!tf_surgery_begin(surface, INT_MAX / 3 - 2));
    ck_assert_int_eq(triangles_of(surface), 4);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_refusal_changes_no_bit)
{
    static surgery_run run;
    static surgery_counts counts;
    int refused = 0;
    surgery_run_begin(&run, generator_new((uint64_t)_i),
                      (adaptive_scene_kind)_i, &counts);
    for (long i = 0; i < cases(1500); i++) {
        uint64_t hash = surgery_run_hash(&run);
        surgery_choice request = surgery_run_choose(&run);
        if (operate(&run, &request) == TF_COMMITTED)
            continue;
        ck_assert_uint_eq(surgery_run_hash(&run), hash);
        refused++;
    }
    ck_assert_int_gt(refused, 0);
    surgery_run_end(&run);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/surgery");
    TCase *tcase = tcase_create("surgery");
    tcase_add_test(tcase, a_patch_replaces_a_patch);
    tcase_add_test(tcase, only_boundary_edges_are_listed_as_kept);
    tcase_add_test(tcase, too_many_triangles_are_refused);
    tcase_add_loop_test(tcase, a_refusal_changes_no_bit, 0, ADAPTIVE_SCENES);
    suite_add_tcase(suite, tcase);
    return suite;
}
