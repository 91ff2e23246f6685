// Surgery in stages.
#include "topology/stage.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "surgery/trial.h"

// A corner of a tetrahedron moves out, and then further: the triangles of the
// first stage are there in the second one, and go then.
START_TEST(a_stage_replaces_triangles_of_an_earlier_one)
{
    static const double near[] = {2, 2, 2}, far[] = {3, 3, 3};
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert(tf_surgery_begin(surface, 6));
    int first = tf_surgery_place(surface, near);
    for (int c = tf_first_corner(surface, 0); c != TF_NONE;
         c = tf_next_corner(surface, c)) {
        tf_surgery_remove(surface, c / 3);
        tf_surgery_add(surface, first,
                       tf_vertex_at(surface, tf_corner_after(c)),
                       tf_vertex_at(surface, tf_corner_before(c)));
    }
    ck_assert_int_eq(tf_surgery_try(surface), TF_COMMITTED);
    tf_surgery_sweep(surface, 0, first, 1, 2);
    tf_surgery_end_stage(surface);
    ck_assert_int_eq(surface->surgery.earlier, 3);
    ck_assert_int_eq(surface->surgery.sweeps, 0);
    tf_surgery_withdraw(surface, 2, first, 1);
    tf_surgery_withdraw(surface, first, 3, 2);
    tf_surgery_withdraw(surface, 1, 3, first);
    ck_assert_int_eq(surface->surgery.earlier, 0);
    int second = tf_surgery_place(surface, far);
    ck_assert_int_eq(second, first + 1);
    for (int c = tf_first_corner(surface, 0); c != TF_NONE;
         c = tf_next_corner(surface, c))
        tf_surgery_add(surface, second,
                       tf_vertex_at(surface, tf_corner_after(c)),
                       tf_vertex_at(surface, tf_corner_before(c)));
    ck_assert_int_eq(tf_surgery_try(surface), TF_COMMITTED);
    tf_surgery_accept(surface);
    tf_surgery_commit(surface);
    ck_assert_int_eq(triangles_of(surface), 4);
    ck_assert_int_eq(tf_star_size(surface, second), 3);
    ck_assert_int_eq(tf_first_corner(surface, first), TF_NONE);
    tf_adaptive_free(surface);
}
END_TEST

/// Adds a triangle on an edge of the sheet, upwards.
static void add_fin(tf_adaptive_surface *surface, double x, double y, double z)
{
    const double position[] = {x, y, z};
    tf_surgery_add(surface, 0, 1, tf_surgery_place(surface, position));
}

START_TEST(triangles_of_earlier_stages_are_obstacles)
{
    tf_adaptive_surface *surface = adaptive_sheet(1, 1);
    ck_assert(tf_surgery_begin(surface, 6));
    add_fin(surface, 0.5, -1, 1);
    ck_assert_int_eq(tf_surgery_try(surface), TF_COMMITTED);
    tf_surgery_end_stage(surface);
    add_fin(surface, 0.5, -2, 2);
    ck_assert_int_eq(tf_surgery_try(surface), TF_OVERLAPPED);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/stage");
    TCase *tcase = tcase_create("stages");
    tcase_add_test(tcase, a_stage_replaces_triangles_of_an_earlier_one);
    tcase_add_test(tcase, triangles_of_earlier_stages_are_obstacles);
    suite_add_tcase(suite, tcase);
    return suite;
}
