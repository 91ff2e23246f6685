#include "base/version.h"

#include "support/support.h"

#include <stdio.h>

START_TEST(the_library_has_the_version_of_its_header)
{
    ck_assert_str_eq(tf_version(), TF_VERSION);
}
END_TEST

START_TEST(a_version_is_its_three_numbers)
{
    char numbers[64];
    snprintf(numbers, sizeof numbers, "%d.%d.%d", TF_VERSION_MAJOR,
             TF_VERSION_MINOR, TF_VERSION_PATCH);
    ck_assert_str_eq(TF_VERSION, numbers);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/version");
    TCase *tcase = tcase_create("version");
    tcase_add_test(tcase, the_library_has_the_version_of_its_header);
    tcase_add_test(tcase, a_version_is_its_three_numbers);
    suite_add_tcase(suite, tcase);
    return suite;
}
