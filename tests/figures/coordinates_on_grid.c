#include "figures/numbers.h"

/// The largest is below 1, so the 62nd place below 1 is the last of the grid.
START_TEST(places_are_counted_from_the_largest)
{
    static const double d = 0x1.6a09e667f3bcdp-9, e = 0x1.72ba43fff3717p-12;
    char *text = printed(&fig_coordinates_on_grid);
    expect_number(text, "unit", -62);
    expect_number(text, "on_grid", 4);
    int of_d = (int)number_of(text, "last_of_d");
    int of_e = (int)number_of(text, "last_of_e");
    ck_assert(fmod(ldexp(d, -of_d), 2) == 1);
    ck_assert(fmod(ldexp(e, -of_e), 2) == 1);
    ck_assert_int_ge(of_d, -62);
    ck_assert_int_lt(of_e, -62);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/coordinates_on_grid",
                    places_are_counted_from_the_largest);
}
