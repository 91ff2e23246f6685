#include "figures/numbers.h"

#include "geometry/sweep.h"

START_TEST(all_staircases_are_drawn)
{
    int count = 0;
    for (int vertices = 1; vertices <= TF_VERTICES; vertices++)
        count += vertices;
    char *text = printed(&fig_staircase);
    expect_number(text, "staircases", count);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/staircase", all_staircases_are_drawn);
}
