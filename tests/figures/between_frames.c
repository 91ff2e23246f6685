#include "figures/numbers.h"

START_TEST(contact_is_between_frames)
{
    // The drop falls from 2 to -3.2 in four frames, past 0.
    char *text = printed(&fig_between_frames);
    expect_number(text, "toi", 4 * 2 / 5.2);
    ck_assert_double_ne(round(number_of(text, "toi")), number_of(text, "toi"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/between_frames", contact_is_between_frames);
}
