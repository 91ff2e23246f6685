#include "figures/numbers.h"

START_TEST(a_key_shuffles_the_bits_of_a_cell)
{
    char *text = printed(&fig_z_order);
    // 101 and 011, from the lowest bit up, x first.
    const int x = 5, y = 3;
    int key = 0;
    for (int i = 0; i < 3; i++)
        key += (x / (1 << i) % 2) * (1 << 2 * i) +
               (y / (1 << i) % 2) * (2 << 2 * i);
    expect_number(text, "marked", key);
    expect_number(text, "leaves", number_of(text, "points") / 16);
    // Far less than that of leaves of points at random.
    ck_assert_double_lt(number_of(text, "mean_side"), 0.3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/z_order", a_key_shuffles_the_bits_of_a_cell);
}
