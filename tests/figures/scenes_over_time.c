#include "figures/numbers.h"

static void expect_scene(const char *text, const char *contacts,
                         const char *stretch)
{
    ck_assert_double_gt(number_of(text, contacts), 1000);
    ck_assert_double_gt(number_of(text, stretch), 1);
    ck_assert_double_lt(number_of(text, stretch), 2);
}

START_TEST(nothing_is_stretched_to_twice_its_length)
{
    char *text = printed(&fig_scenes_over_time);
    expect_scene(text, "contacts_sphere", "stretch_sphere");
    expect_scene(text, "contacts_twist", "stretch_twist");
    free(text);
}
END_TEST

START_TEST(failsafes_are_rare)
{
    char *text = printed(&fig_scenes_over_time);
    ck_assert_double_le(number_of(text, "failsafe_sphere"),
                        0.02 * number_of(text, "steps_sphere"));
    ck_assert_double_le(number_of(text, "failsafe_twist"),
                        0.02 * number_of(text, "steps_twist"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/scenes_over_time",
                        nothing_is_stretched_to_twice_its_length);
    TCase *more = tcase_create("more");
    tcase_add_test(more, failsafes_are_rare);
    suite_add_tcase(s, more);
    return s;
}
