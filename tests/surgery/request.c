// What every operation refuses to begin with.
#include "surgery/request.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/collapse.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"

#include <math.h>
#include <signal.h>

static tf_status all_statuses(tf_adaptive_surface *surface, int a, int b,
                              const double position[3])
{
    tf_outcome outcome[5];
    int vertex;
    const tf_status status[] = {
        tf_adaptive_split(surface, a, b, position, &vertex, &outcome[0]),
        tf_adaptive_collapse_to(surface, a, b, position, &outcome[1]),
        tf_adaptive_collapse(surface, a, b, &outcome[2]),
        tf_adaptive_flip(surface, a, b, &outcome[3]),
        tf_adaptive_move(surface, a, position, &outcome[4])};
    int finite = isfinite(position[0]) && isfinite(position[2]);
    for (int i = 0; i < 5; i++) {
        if ((i == 2 || i == 3) && !finite)
            continue;
        ck_assert_int_eq(outcome[i], TF_NO_OUTCOME);
        ck_assert_int_eq(status[i], status[0]);
    }
    return status[0];
}

START_TEST(invalid_requests_are_rejected)
{
    static const double position[] = {2, 2, 2}, nan[] = {NAN, 0, 0};
    static const double infinite[] = {0, 0, -INFINITY};
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert_int_eq(all_statuses(surface, -1, 0, position), TF_BAD_INDEX);
    ck_assert_int_eq(all_statuses(surface, 4, 0, position), TF_BAD_INDEX);
    ck_assert_int_eq(all_statuses(surface, 0, 1, nan), TF_NOT_FINITE);
    ck_assert_int_eq(all_statuses(surface, 0, 1, infinite), TF_NOT_FINITE);
    ck_assert_int_eq(triangles_of(surface), 4);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(an_operation_needs_an_outcome)
{
    static tf_outcome *nowhere;
    tf_adaptive_flip(adaptive_tetrahedron(), 0, 1, nowhere);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/request");
    TCase *tcase = tcase_create("requests");
    tcase_add_test(tcase, invalid_requests_are_rejected);
    tcase_add_test_raise_signal(tcase, an_operation_needs_an_outcome, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
