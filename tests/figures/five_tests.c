#include "figures/numbers.h"

START_TEST(only_one_test_objects_to_each)
{
    char *text = printed(&fig_five_tests), key[16];
    for (const char *test = "DSVEX"; *test; test++) {
        snprintf(key, sizeof key, "%c_refused", *test);
        expect_number(text, key, 1);
        snprintf(key, sizeof key, "%c_alone", *test);
        expect_number(text, key, 1);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/five_tests", only_one_test_objects_to_each);
}
