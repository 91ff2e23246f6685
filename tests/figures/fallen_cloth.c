#include "figures/numbers.h"

START_TEST(both_scenes_are_coarse)
{
    char *text = printed(&fig_fallen_cloth);
    ck_assert_double_gt(number_of(text, "triangles_sphere"), 500);
    ck_assert_double_gt(number_of(text, "triangles_stack"), 500);
    ck_assert_double_lt(number_of(text, "triangles_sphere"), 2000);
    ck_assert_double_lt(number_of(text, "triangles_stack"), 2000);
    ck_assert_double_gt(number_of(text, "step_sphere"), 50);
    ck_assert_double_gt(number_of(text, "step_stack"), 50);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/fallen_cloth", both_scenes_are_coarse);
}
