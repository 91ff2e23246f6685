#include "figures/numbers.h"

START_TEST(one_overtakes_in_time)
{
    // By hand: 0.1 + 0.8 t = 0.4 + 0.1 t.
    char *text = printed(&fig_points_on_a_line);
    expect_number(text, "overtakes", 3. / 7);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/points_on_a_line", one_overtakes_in_time);
}
