#include "figures/numbers.h"

START_TEST(contact_is_where_the_text_has_it)
{
    char *text = printed(&fig_rising_sweep);
    // The pair of the text: 11/17.
    expect_number(text, "toi", 11.0 / 17);
    expect_number(text, "film_still", 11.0 / 17);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/rising_sweep", contact_is_where_the_text_has_it);
}
