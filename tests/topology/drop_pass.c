// The pass that drops small parts.
#include "topology/drop_pass.h"

#include "support/blobs.h"
#include "support/support.h"
#include "topology/reconnector.h"

static blobs made;

static tf_reconnect_report report;

static size_t dropped(tf_adaptive_surface *surface, double limit)
{
    tf_reconnector reconnector = {.surface = surface,
                                  .lengths = {.drop = limit}};
    ck_assert_int_eq(tf_drop_pass(&reconnector), TF_OK);
    tf_reconnector_free(&reconnector);
    report = reconnector.report;
    return report.tried[TF_DROP][TF_COMMITTED];
}

// Balls of radius 1, 0.1 and 0.2, the last of which holds one of 0.05.
START_TEST(small_components_that_hold_nothing_are_dropped)
{
    static const double radius[] = {1, 0.1, 0.2, 0.05}, at[] = {0, 2, 3, 3};
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 4; i++) {
        const double middle[] = {at[i], 0, 0};
        add_ball(&made, middle, radius[i], 2);
    }
    tf_adaptive_surface *surface = blobs_surface(&made);
    double before = volume_of(surface);
    ck_assert_uint_eq(dropped(surface, 1e-5), 0);
    ck_assert_uint_eq(dropped(surface, 5e-4), 1); // 0.05
    ck_assert_uint_eq(dropped(surface, 3e-3), 1); // 0.1
    ck_assert_double_eq_tol(report.gained[TF_DROP] * 1.125,
                            volume_of(surface) - before, 1e-12);
    ck_assert_int_eq(parts_of(surface), 2);
    ck_assert_uint_eq(dropped(surface, 0.03), 1); // 0.2, empty by now
    ck_assert_int_eq(parts_of(surface), 1);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_component_is_dropped_after_what_it_held)
{
    static const double radius[] = {0.2, 0.05}, at[] = {0, 0};
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 2; i++) {
        const double middle[] = {at[i], 0, 0};
        add_ball(&made, middle, radius[i], 2);
    }
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_uint_eq(dropped(surface, 1), 1);
    ck_assert_uint_eq(report.tried[TF_DROP][TF_PASSED_VERTEX], 1);
    ck_assert_uint_eq(dropped(surface, 1), 1);
    ck_assert_int_eq(parts_of(surface), 0);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/drop_pass");
    TCase *tcase = tcase_create("dropping");
    tcase_add_test(tcase, small_components_that_hold_nothing_are_dropped);
    tcase_add_test(tcase, a_component_is_dropped_after_what_it_held);
    suite_add_tcase(suite, tcase);
    return suite;
}
