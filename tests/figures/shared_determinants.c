#include "figures/numbers.h"

START_TEST(fourteen_and_ten_are_left)
{
    char *text = printed(&fig_shared_determinants);
    // Four pairs and three tetrahedra of six coordinates.
    expect_number(text, "ee_coordinates", 4 * 6);
    expect_number(text, "pt_coordinates", 3 * 6);
    // A crease of an edge beside either piece of the other; the tetrahedra of
    // the start and of the end, twice each.
    expect_number(text, "ee_repeated", 4 + 2);
    expect_number(text, "ee_sums", 4);
    expect_number(text, "ee_determinants", 14);
    // Two walls; the lone event of the triangle and that of the point.
    expect_number(text, "pt_repeated", 2 + 2);
    expect_number(text, "pt_sums", 4);
    expect_number(text, "pt_determinants", 10);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/shared_determinants", fourteen_and_ten_are_left);
}
