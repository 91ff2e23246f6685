#include "figures/numbers.h"

START_TEST(twelve_triangles_bound_a_ball)
{
    char *text = printed(&fig_merge_stages);
    expect_number(text, "walls", 4);
    expect_number(text, "tube", 8);
    expect_number(text, "triangles", 12);
    expect_number(text, "corners", 8);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/merge_stages", twelve_triangles_bound_a_ball);
}
