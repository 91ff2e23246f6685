#include "files/choice.h"

#include "support/support.h"

#include <stddef.h>
#include <string.h>

static const int one = 1, two = 2, three = 3;

static const tf_choice numbers[] = {
    {"one", &one}, {"two", &two}, {"three", &three}, {NULL, NULL}};

START_TEST(a_name_finds_what_it_stands_for)
{
    ck_assert_ptr_eq(tf_choice_named(numbers, "one"), &one);
    ck_assert_ptr_eq(tf_choice_named(numbers, "three"), &three);
}
END_TEST

START_TEST(other_names_find_nothing)
{
    static const char *const names[] = {"", "o", "One", "one ", "four"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ck_assert_msg(!tf_choice_named(numbers, names[i]), "'%s'", names[i]);
}
END_TEST

START_TEST(names_are_listed_in_words)
{
    ck_assert_str_eq(tf_list_choices(numbers).text, "one, two or three");
    ck_assert_str_eq(tf_list_choices(numbers + 1).text, "two or three");
    ck_assert_str_eq(tf_list_choices(numbers + 2).text, "three");
    ck_assert_str_eq(tf_list_choices(numbers + 3).text, "");
}
END_TEST

START_TEST(a_list_that_is_too_long_is_cut)
{
    static const char ten[] = "0123456789";
    tf_choice many[20] = {{NULL, NULL}};
    for (int i = 0; i < 19; i++)
        many[i] = (tf_choice){ten, &one};
    ck_assert_uint_eq(strlen(tf_list_choices(many).text), TF_CHOICES_ROOM - 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/choice");
    TCase *choices = tcase_create("choices");
    tcase_add_test(choices, a_name_finds_what_it_stands_for);
    tcase_add_test(choices, other_names_find_nothing);
    tcase_add_test(choices, names_are_listed_in_words);
    tcase_add_test(choices, a_list_that_is_too_long_is_cut);
    suite_add_tcase(suite, choices);
    return suite;
}
