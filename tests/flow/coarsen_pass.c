// Short edges collapse, and the volume is kept.
#include "support/flows.h"
#include "support/support.h"

START_TEST(the_volume_is_kept)
{
    tf_flow_state *flow =
        flow_begin(adaptive_bumpy_sphere(8, 0.05, (uint64_t)_i), 0.6, 0);
    expect_kept_volume(flow, TF_COLLAPSE, tf_coarsen_pass, true);
    expect_embedded(flow->remesher.surface);
    flow_end(flow);
}
END_TEST

START_TEST(it_is_not_kept_without_care)
{
    tf_flow_state *flow =
        flow_begin(adaptive_bumpy_sphere(8, 0.05, 0), 0.6, 1U << TF_COLLAPSE);
    expect_kept_volume(flow, TF_COLLAPSE, tf_coarsen_pass, false);
    flow_end(flow);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/coarsen_pass");
    TCase *tcase = tcase_create("volume");
    tcase_add_loop_test(tcase, the_volume_is_kept, 0, 3);
    tcase_add_test(tcase, it_is_not_kept_without_care);
    suite_add_tcase(suite, tcase);
    return suite;
}
