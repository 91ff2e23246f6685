// What the passes of a reconnection have in common.
#include "topology/reconnector.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

START_TEST(outcomes_are_counted)
{
    tf_reconnector reconnector = {0};
    const tf_reconnect_report *report = &reconnector.report;
    tf_reconnector_count(&reconnector, TF_PINCH, TF_OVERLAPPED, 3);
    tf_reconnector_count(&reconnector, TF_PINCH, TF_COMMITTED, -0.5);
    tf_reconnector_count(&reconnector, TF_PINCH, TF_COMMITTED, -0.25);
    ck_assert_uint_eq(report->tried[TF_PINCH][TF_OVERLAPPED], 1);
    ck_assert_uint_eq(report->tried[TF_PINCH][TF_COMMITTED], 2);
    ck_assert_double_eq(report->gained[TF_PINCH], -0.75);
    ck_assert_double_eq(report->gained[TF_MERGE], 0);
    tf_reconnector_free(&reconnector);
}
END_TEST

// A regular tetrahedron in a cube with sides of 2: a third of that.
START_TEST(volumes_are_measured)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    const int all[] = {3, 1, 0, 2};
    ck_assert_double_eq_tol(tf_volume_at(surface, 4, all), 8 / 3.0, 1e-15);
    ck_assert_double_eq_tol(tf_volume_at(surface, 1, all), 0, 1e-15);
    double sum = 0;
    for (int t = 0; t < 4; t++)
        sum += tf_volume_below(surface, t, (tf_vector){{5, 6, 7}});
    ck_assert_double_eq_tol(sum, 8 / 3.0, 1e-13);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/reconnector");
    TCase *tcase = tcase_create("reconnections");
    tcase_add_test(tcase, outcomes_are_counted);
    tcase_add_test(tcase, volumes_are_measured);
    suite_add_tcase(suite, tcase);
    return suite;
}
