#include "figures/numbers.h"

START_TEST(three_scenes_are_drawn)
{
    char *text = printed(&fig_flow_scenes);
    ck_assert_double_gt(number_of(text, "step_turbulence"), 50);
    ck_assert_double_gt(number_of(text, "step_star"), 50);
    ck_assert_double_gt(number_of(text, "step_sheets"), 50);
    ck_assert_double_gt(number_of(text, "triangles_turbulence"), 600);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/flow_scenes", three_scenes_are_drawn);
}
