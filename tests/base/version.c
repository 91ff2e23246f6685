#include "base/version.h"

#include "support/support.h"

#include <stdio.h>

START_TEST(the_library_has_the_version_of_its_header)
{
    ck_assert_str_eq(tf_version(), TF_VERSION);
}
END_TEST

START_TEST(a_version_is_three_numbers)
{
    int major, minor, patch, length = 0;
    ck_assert_int_eq(
        sscanf(tf_version(), "%d.%d.%d%n", &major, &minor, &patch, &length), 3);
    ck_assert_int_eq(tf_version()[length], 0);
    ck_assert(major >= 0 && minor >= 0 && patch >= 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/version");
    TCase *tcase = tcase_create("version");
    tcase_add_test(tcase, the_library_has_the_version_of_its_header);
    tcase_add_test(tcase, a_version_is_three_numbers);
    suite_add_tcase(suite, tcase);
    return suite;
}
