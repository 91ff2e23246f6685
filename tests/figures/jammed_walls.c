#include "figures/numbers.h"

START_TEST(walls_stop_before_they_cross)
{
    char *text = printed(&fig_jammed_walls);
    double first = number_of(text, "first_jam");
    double jammed = number_of(text, "jammed");
    double meeting = number_of(text, "meeting");
    expect_number(text, "meeting", 30);
    ck_assert_double_le(first, meeting);
    ck_assert_double_ge(first, meeting - 5);
    // The script asks for room that the zones do not find.
    ck_assert_double_gt(number_of(text, "asked"), 0);
    ck_assert_double_lt(number_of(text, "asked"), number_of(text, "jam_gap"));
    // Until the script has turned back, and the walls may open.
    ck_assert_double_ge(first + jammed, 2 * 45 - meeting);
    ck_assert_double_lt(first + jammed, number_of(text, "steps"));
    ck_assert_double_gt(number_of(text, "jam_gap"), 0);
    ck_assert_double_le(number_of(text, "jump"), 0.12);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/jammed_walls", walls_stop_before_they_cross);
}
