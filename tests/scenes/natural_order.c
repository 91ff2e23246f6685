// The order of names as people take it, and of the frames of a sequence.
#include "scenes/natural_order.h"

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int sign(int number)
{
    return (number > 0) - (number < 0);
}

// Names -----------------------------------------------------------------------

START_TEST(numbers_count_as_numbers)
{
    static const char *const sorted[] = {"",
                                         "0",
                                         "00",
                                         "01",
                                         "1",
                                         "2",
                                         "9",
                                         "010",
                                         "10",
                                         "a",
                                         "a0",
                                         "a1",
                                         "a1b",
                                         "a1b1",
                                         "a1b2",
                                         "a1b10",
                                         "a2",
                                         "a2b",
                                         "a10",
                                         "a99999999999999999998",
                                         "a99999999999999999999",
                                         "a100000000000000000000",
                                         "aa",
                                         "b",
                                         "\xc3\xa9"};
    int count = sizeof sorted / sizeof *sorted;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            ck_assert_msg(sign(tf_natural_compare(sorted[i], sorted[j])) ==
                              sign(i - j),
                          "'%s' and '%s'", sorted[i], sorted[j]);
}
END_TEST

START_TEST(one_frame_has_names_that_differ_in_zeros_or_gz)
{
    ck_assert(tf_are_of_one_frame("b7.obj", "b07.obj"));
    ck_assert(tf_are_of_one_frame("b07.obj", "b7.obj"));
    ck_assert(tf_are_of_one_frame("b7.obj", "b7.obj.gz"));
    ck_assert(tf_are_of_one_frame("b7.obj.gz", "b07.obj"));
    ck_assert(tf_are_of_one_frame("b0", "b000"));
    ck_assert(tf_are_of_one_frame("b7.obj", "b7.obj.GZ"));
    ck_assert(!tf_are_of_one_frame("b7.obj", "b70.obj"));
    ck_assert(!tf_are_of_one_frame("b7.obj", "b7.obj.g"));
    ck_assert(!tf_are_of_one_frame("b7.obj", "b7.off"));
    ck_assert(!tf_are_of_one_frame("b1", "b11"));
}
END_TEST

START_TEST(leading_zeros_decide_last)
{
    ck_assert_int_lt(tf_natural_compare("01", "1"), 0);
    ck_assert_int_gt(tf_natural_compare("1", "01"), 0);
    ck_assert_int_lt(tf_natural_compare("a1b2", "a01b10"), 0);
    ck_assert_int_gt(tf_natural_compare("a010", "a9"), 0);
    ck_assert_int_eq(tf_natural_compare("a010", "a010"), 0);
}
END_TEST

/// A word of few letters, in which digits are likely.
static void make_word(generator *random, char word[12])
{
    int length = below(random, 10);
    for (int i = 0; i < length; i++)
        word[i] = "0019a."[below(random, 6)];
    word[length] = '\0';
}

START_TEST(it_is_an_order)
{
    generator random = generator_new(0x0a7);
    for (long i = 0; i < cases(200000); i++) {
        char word[3][12];
        for (int k = 0; k < 3; k++)
            make_word(&random, word[k]);
        int ab = sign(tf_natural_compare(word[0], word[1]));
        int bc = sign(tf_natural_compare(word[1], word[2]));
        int ac = sign(tf_natural_compare(word[0], word[2]));
        ck_assert_int_eq(ab, -sign(tf_natural_compare(word[1], word[0])));
        ck_assert_int_eq(ab == 0, strcmp(word[0], word[1]) == 0);
        ck_assert_msg(ab != bc || ab == 0 || ac == ab, "'%s' '%s' '%s'",
                      word[0], word[1], word[2]);
    }
}
END_TEST

START_TEST(frames_of_any_number_are_sorted)
{
    enum {
        FRAMES = 1200
    };
    static char text[FRAMES][20];
    char *name[FRAMES];
    generator random = generator_new(0x0a8);
    for (int i = 0; i < FRAMES; i++) {
        snprintf(text[i], sizeof text[i], "shell%d.obj", i);
        name[i] = text[i];
    }
    for (int i = FRAMES - 1; i > 0; i--) {
        int j = below(&random, i + 1);
        char *swapped = name[i];
        name[i] = name[j];
        name[j] = swapped;
    }
    tf_natural_sort(name, FRAMES);
    for (int i = 0; i < FRAMES; i++)
        ck_assert_ptr_eq(name[i], text[i]);
}
END_TEST

// Frames ----------------------------------------------------------------------

/// Frames as they are given, divided by blanks; as they are taken, NULL: the
/// same; and what is said.
static const struct {
    const char *given, *taken, *said;
} orders[] = {
    {"shell0 shell1 shell10 shell2", "shell0 shell1 shell2 shell10",
     "tanglefree: the frames from shell0 to shell10 are taken in the order of "
     "their numbers\ntanglefree: shell10 follows shell2; frames may be missing "
     "in between, but this is taken as one step\n"},
    {"f0 f1 f10 f2 f3 f4 f5 f6 f7 f8 f9", "f0 f1 f2 f3 f4 f5 f6 f7 f8 f9 f10",
     "tanglefree: the frames from f0 to f10 are taken in the order of their "
     "numbers\n"},
    {"1/a10.obj 1/a8.obj 1/a9.obj", "1/a8.obj 1/a9.obj 1/a10.obj",
     "tanglefree: the frames from 1/a8.obj to 1/a10.obj are taken in the order "
     "of their numbers\n"},
    {"a1 a2 a3", NULL, ""},
    {"a10 a20 a30", NULL, ""},
    {"a3 a2 a1", NULL, ""},
    {"a010 a011 a012", NULL, ""},
    {"a1", NULL, ""},
    {"a1 a2", NULL, ""},
    {"a1 a7", NULL, ""},
    {"a2 a1", NULL, ""},
    {"a9 a10", NULL, ""},
    {"a10 a9", NULL,
     "tanglefree: a9 follows a10; the step goes from the higher number to the "
     "lower one\n"},
    {"a1 a2 a4", NULL,
     "tanglefree: a4 follows a2; frames may be missing in between, but this is "
     "taken as one step\n"},
    {"a4 a2 a1", NULL,
     "tanglefree: a2 follows a4; frames may be missing in between, but this is "
     "taken as one step\n"},
    {"a2 a1 a3", NULL,
     "tanglefree: a3 follows a1; the frames are taken in this order, although "
     "their numbers are not in order\n"},
    {"a1 a3 a2", NULL,
     "tanglefree: a2 follows a3; the frames are taken in this order, although "
     "their numbers are not in order\n"},
    {"start end middle", NULL, ""},
    {"rest a1 a2", NULL, ""},
    {"a1 b2 a3", NULL, ""},
    {"a1b1 a1b2 a2b1", NULL, ""},
    {"a1 a1 a2", NULL, ""},
    {"above below above above", NULL, ""},
};

START_TEST(frames_are_put_in_order)
{
    char given[200], again[200] = "", *name[20];
    int count = 0;
    snprintf(given, sizeof given, "%s", orders[_i].given);
    for (char *at = strtok(given, " "); at; at = strtok(NULL, " "))
        name[count++] = at;
    ck_assert(freopen("err", "w", stderr) != NULL);
    tf_order_frames(name, count);
    fflush(stderr);
    for (int i = 0; i < count; i++) {
        strcat(again, i > 0 ? " " : "");
        strcat(again, name[i]);
    }
    ck_assert_str_eq(again,
                     orders[_i].taken ? orders[_i].taken : orders[_i].given);
    ck_assert_str_eq(file_text("err"), orders[_i].said);
}
END_TEST

START_TEST(numbered_names_are_known)
{
    static const struct {
        char *name[4];
        int count;
        bool numbered;
    } names[] = {
        {{"a1", "a2", "a3"}, 3, true},
        {{"a9", "a2", "a30.", "a3"}, 2, false},
        {{"a9", "a2", "a30", "a3"}, 4, true},
        {{"a1", "a2", "a2"}, 3, false},
        {{"a1", "a2", "b3"}, 3, false},
        {{"a1"}, 1, false},
        {{"a1b1", "a2b1", "a3b2"}, 3, false},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ck_assert_msg(tf_are_numbered(names[i].name, names[i].count) ==
                          names[i].numbered,
                      "%zu", i);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/natural_order");
    TCase *names = tcase_create("names");
    tcase_add_test(names, numbers_count_as_numbers);
    tcase_add_test(names, one_frame_has_names_that_differ_in_zeros_or_gz);
    tcase_add_test(names, leading_zeros_decide_last);
    tcase_add_test(names, it_is_an_order);
    tcase_add_test(names, frames_of_any_number_are_sorted);
    suite_add_tcase(suite, names);

    TCase *frames = tcase_create("frames");
    tcase_add_checked_fixture(frames, enter_folder, leave_folder);
    tcase_add_loop_test(frames, frames_are_put_in_order, 0,
                        sizeof orders / sizeof *orders);
    tcase_add_test(frames, numbered_names_are_known);
    suite_add_tcase(suite, frames);
    return suite;
}
