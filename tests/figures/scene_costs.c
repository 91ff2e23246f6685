#include "figures/numbers.h"

START_TEST(each_scene_was_timed)
{
    static const char *const scenes[] = {
        "sphere", "stack", "twist", "knot", "curtain", "flag", "plane-chain"};
    char *text = printed(&fig_scene_costs);
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        char key[64];
        snprintf(key, sizeof key, "dynamics_%s", scenes[i]);
        ck_assert_double_gt(number_of(text, key), 0);
        snprintf(key, sizeof key, "response_%s", scenes[i]);
        ck_assert_double_gt(number_of(text, key), 0);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/scene_costs", each_scene_was_timed);
}
