#include "figures/numbers.h"

START_TEST(friction_keeps_a_heap_high)
{
    char *text = printed(&fig_three_frictions);
    ck_assert_double_lt(number_of(text, "height_none"),
                        number_of(text, "height_some"));
    ck_assert_double_lt(number_of(text, "height_some"),
                        number_of(text, "height_much"));
    free(text);
}
END_TEST

START_TEST(separation_spares_contacts)
{
    char *text = printed(&fig_three_frictions);
    ck_assert_double_gt(number_of(text, "contacts_close"),
                        2 * number_of(text, "contacts_some"));
    // "far more to do"
    double close =
        number_of(text, "contacts_close") / number_of(text, "rounds_close");
    double some =
        number_of(text, "contacts_some") / number_of(text, "rounds_some");
    ck_assert_double_gt(close, 5 * some);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/three_frictions", friction_keeps_a_heap_high);
    TCase *more = tcase_create("more");
    tcase_add_test(more, separation_spares_contacts);
    suite_add_tcase(s, more);
    return s;
}
