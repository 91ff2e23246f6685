// Edges turn to shorter diagonals, and the volume is kept.
#include "support/flows.h"
#include "support/support.h"

START_TEST(the_volume_is_kept)
{
    tf_flow_state *flow =
        flow_begin(adaptive_bumpy_sphere(12, 0.033, (uint64_t)_i), 0.2, 0);
    expect_kept_volume(flow, TF_FLIP, tf_turn_pass, true);
    expect_embedded(flow->remesher.surface);
    flow_end(flow);
}
END_TEST

START_TEST(it_is_not_kept_without_care)
{
    tf_flow_state *flow =
        flow_begin(adaptive_bumpy_sphere(12, 0.033, 0), 0.2, 1U << TF_FLIP);
    expect_kept_volume(flow, TF_FLIP, tf_turn_pass, false);
    flow_end(flow);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/turn_pass");
    TCase *tcase = tcase_create("volume");
    tcase_add_loop_test(tcase, the_volume_is_kept, 0, 3);
    tcase_add_test(tcase, it_is_not_kept_without_care);
    suite_add_tcase(suite, tcase);
    return suite;
}
