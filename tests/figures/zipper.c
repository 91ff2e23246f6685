#include "figures/numbers.h"

START_TEST(twelve_triangles_bound_a_ball)
{
    char *text = printed(&fig_zipper);
    expect_number(text, "walls", 4);
    expect_number(text, "tube", 8);
    expect_number(text, "triangles", 12);
    expect_number(text, "corners", 8);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/zipper", twelve_triangles_bound_a_ball);
}
