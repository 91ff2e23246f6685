// Volume is given back by moves along normals.
#include "support/flows.h"
#include "support/support.h"

#include <math.h>

START_TEST(what_is_given_is_gained)
{
    tf_flow_state *flow =
        flow_begin(adaptive_bumpy_sphere(6, 0.02, (uint64_t)_i), 0.3, 0);
    generator random = generator_new(100);
    mpq_t before;
    mpq_init(before);
    for (int i = 0; i < 20; i++) {
        int vertex[4];
        for (int k = 0; k < 4; k++)
            vertex[k] = 25 * k + below(&random, 25);
        double more = uniform(&random, -0.004, 0.004);
        exact_volume(flow->remesher.surface, before);
        ck_assert_int_eq(tf_flow_restore_volume(flow, more, 4, vertex), TF_OK);
        double gained = volume_gained(flow->remesher.surface, before);
        ck_assert_double_eq_tol(gained, more / 6, 1e-16);
    }
    ck_assert_uint_eq(flow->report->shifted[TF_COMMITTED], 80);
    mpq_clear(before);
    flow_end(flow);
}
END_TEST

START_TEST(nothing_moves_far)
{
    static const int vertex[] = {3};
    tf_flow_state *flow = flow_begin(adaptive_bumpy_sphere(6, 0.02, 0), 0.3, 0);
    mpq_t before;
    mpq_init(before);
    exact_volume(flow->remesher.surface, before);
    ck_assert_int_eq(tf_flow_restore_volume(flow, 1, 1, vertex), TF_OK);
    ck_assert_double_eq(volume_gained(flow->remesher.surface, before), 0);
    mpq_clear(before);
    flow_end(flow);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/compensate");
    TCase *tcase = tcase_create("volume");
    tcase_add_loop_test(tcase, what_is_given_is_gained, 0, 3);
    tcase_add_test(tcase, nothing_moves_far);
    suite_add_tcase(suite, tcase);
    return suite;
}
