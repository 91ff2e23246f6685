#include "base/sized.h"

#include "support/support.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/// Options of three versions.
typedef struct first {
    size_t size;
    int a;
    int b;
} first;

typedef struct second {
    size_t size;
    int a;
    int b;
    double c;
} second;

typedef struct third {
    size_t size;
    int a;
    int b;
    double c;
    double d;
} third;

static tf_status read_second(second *read, const void *given, tf_error *error)
{
    memset(read, 0xa5, sizeof *read);
    return tf_options_read(read, sizeof *read, given, sizeof(first), error);
}

START_TEST(no_options_are_all_zero)
{
    second read;
    ck_assert_int_eq(read_second(&read, NULL, NULL), TF_OK);
    ck_assert(read.a == 0 && read.b == 0 && read.c == 0 && read.size == 0);
}
END_TEST

START_TEST(size_zero_is_the_first_version)
{
    // What follows the first version's members must not be read.
    second given = {0, 1, 2, 3}, read;
    ck_assert_int_eq(read_second(&read, &given, NULL), TF_OK);
    ck_assert(read.a == 1 && read.b == 2 && read.c == 0);
}
END_TEST

START_TEST(older_callers_have_zeros)
{
    first *given = malloc(sizeof *given); // a sanitizer finds reads behind it
    *given = (first){sizeof *given, 1, 2};
    second read;
    ck_assert_int_eq(read_second(&read, given, NULL), TF_OK);
    ck_assert(read.a == 1 && read.b == 2 && read.c == 0);
    free(given);
}
END_TEST

START_TEST(newer_callers_may_not_set_what_is_unknown)
{
    third given = {sizeof given, 1, 2, 3, 0};
    second read;
    tf_error error;
    ck_assert_int_eq(read_second(&read, &given, &error), TF_OK);
    ck_assert(read.a == 1 && read.b == 2 && read.c == 3);
    given.d = 1;
    ck_assert_int_eq(read_second(&read, &given, &error), TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "size");
}
END_TEST

START_TEST(size_of_no_version_is_bad)
{
    // What is there is not read: there is nothing behind it.
    second *given = calloc(1, sizeof *given), read;
    given->size = SIZE_MAX;
    ck_assert_int_eq(read_second(&read, given, NULL), TF_BAD_OPTION);
    given->size = 1 << 20;
    ck_assert_int_eq(read_second(&read, given, NULL), TF_BAD_OPTION);
    free(given);
}
END_TEST

START_TEST(size_below_the_first_version_is_bad)
{
    second given = {.size = sizeof(first) - 1}, read;
    tf_error error;
    ck_assert_int_eq(read_second(&read, &given, &error), TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "size");
    given.size = 1;
    ck_assert_int_eq(read_second(&read, &given, NULL), TF_BAD_OPTION);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/sized");
    TCase *tcase = tcase_create("versions");
    tcase_add_test(tcase, no_options_are_all_zero);
    tcase_add_test(tcase, size_zero_is_the_first_version);
    tcase_add_test(tcase, older_callers_have_zeros);
    tcase_add_test(tcase, newer_callers_may_not_set_what_is_unknown);
    tcase_add_test(tcase, size_of_no_version_is_bad);
    tcase_add_test(tcase, size_below_the_first_version_is_bad);
    suite_add_tcase(suite, tcase);
    return suite;
}
