#include "figures/numbers.h"

START_TEST(three_scenes_are_drawn)
{
    char *text = printed(&fig_pulled_cloth);
    ck_assert_double_gt(number_of(text, "step_knot"), 50);
    ck_assert_double_gt(number_of(text, "step_curtain"), 50);
    ck_assert_double_gt(number_of(text, "step_flag"), 50);
    ck_assert_double_gt(number_of(text, "triangles_knot"), 500);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/pulled_cloth", three_scenes_are_drawn);
}
