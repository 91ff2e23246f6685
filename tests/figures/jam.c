#include "figures/numbers.h"

START_TEST(walls_stop_where_they_would_cross)
{
    char *text = printed(&fig_jam);
    double first = number_of(text, "first_jam");
    double jammed = number_of(text, "jammed");
    // From the step in which the walls should meet to the one in which they
    // should do so again.
    expect_number(text, "first_jam", 30);
    expect_number(text, "jammed", 31);
    expect_number(text, "jam_gap", 2 * number_of(text, "speed"));
    ck_assert_double_lt(first + jammed, number_of(text, "steps"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/jam", walls_stop_where_they_would_cross);
}
