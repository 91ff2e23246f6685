#include "figures/numbers.h"

START_TEST(numbers_of_the_format_are_counted)
{
    // Below 2 and above 0 with three bits and no exponent below -4.
    int normal = 0, subnormal = 0;
    for (int i = 1; i < 32; i++) {
        int odd = i;
        while (odd % 2 == 0)
            odd /= 2;
        normal += odd < 8 && i >= 4;
        subnormal += i < 4;
    }
    char *text = printed(&fig_toy_doubles);
    expect_number(text, "normal", normal);
    expect_number(text, "subnormal", subnormal);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/toy_doubles", numbers_of_the_format_are_counted);
}
