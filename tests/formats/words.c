// Words of a text, line after line.
#include "formats/words.h"

#include "support/meshes.h"
#include "support/program.h"
#include "support/support.h"

#include <string.h>

static tf_mesh_file file;

static tf_words words_of(const char *text)
{
    file = empty_mesh("words");
    return tf_words_of(&file, text, strlen(text));
}

static void expect_fault(long line, const char *words)
{
    ck_assert_int_eq(file.fault->place, line);
    expect_words(file.fault->text, words);
}

START_TEST(ends_of_lines_are_blanks)
{
    tf_words words = words_of("\xEF\xBB\xBF one\n\n\tTwo \r\n three");
    ck_assert(!tf_words_take(&words, "on"));
    ck_assert(!tf_words_take(&words, "ones"));
    ck_assert(tf_words_take(&words, "ONE"));
    ck_assert(tf_words_take(&words, "two"));
    ck_assert_int_eq(words.text.line, 3);
    ck_assert(tf_words_need(&words));
    ck_assert_int_eq(words.text.line, 4);
    ck_assert(tf_words_take(&words, "three"));
    ck_assert(!tf_words_take(&words, ""));
    ck_assert(!tf_words_find(&words));
    ck_assert(!tf_words_need(&words));
    expect_fault(4, "the file ends too early; it may be cut short, or its");
}
END_TEST

START_TEST(comments_end_with_their_lines)
{
    tf_words words = words_of("1#2\n# 3 4\n#\n5 # 6");
    int number;
    words.has_comments = true;
    ck_assert(tf_words_read_integer(&words, 0, &number) && number == 1);
    ck_assert(tf_words_read_integer(&words, 0, &number) && number == 5);
    ck_assert_int_eq(words.text.line, 4);
    ck_assert(!tf_words_find(&words));
    words = words_of("#2");
    ck_assert(tf_words_take(&words, "#2"));
}
END_TEST

START_TEST(words_are_skipped)
{
    tf_words words = words_of("a b\n\nnan");
    ck_assert(tf_words_skip(&words) && tf_words_take(&words, "b"));
    ck_assert(tf_words_skip(&words));
    ck_assert(!tf_words_skip(&words));
    expect_fault(3, "the file ends too early; ");
    file = empty_mesh("words");
    words = tf_words_of(&file, "\n\0", 2);
    ck_assert(!tf_words_skip(&words));
    expect_fault(2, "a NUL byte; ");
}
END_TEST

START_TEST(rests_of_lines_are_skipped)
{
    tf_words words = words_of("a b c\nd\n");
    tf_words_skip_line(&words);
    ck_assert(tf_words_take(&words, "d"));
    tf_words_skip_line(&words);
    tf_words_skip_line(&words);
    ck_assert(!tf_words_find(&words));
}
END_TEST

START_TEST(numbers_are_read)
{
    tf_words words = words_of("1.5 -2\n0x1p-3 7 -7 2147483647");
    double x[3];
    const char *at[3];
    int number;
    ck_assert(tf_words_read_position(&words, x, at));
    ck_assert(x[0] == 1.5 && x[1] == -2 && x[2] == 0.125);
    ck_assert_ptr_eq(at[1], words.start + 4);
    ck_assert_ptr_eq(at[2], words.start + 7);
    ck_assert(tf_words_read_integer(&words, 7, &number) && number == 7);
    ck_assert(tf_words_read_integer(&words, -7, &number) && number == -7);
    ck_assert(tf_words_read_integer(&words, 0, &number));
    ck_assert_int_eq(number, 2147483647);
    ck_assert(!tf_words_read_integer(&words, 0, &number));
    expect_fault(2, "the file ends too early; ");
}
END_TEST

START_TEST(other_numbers_are_refused)
{
    static const struct {
        const char *text;
        int least;
        const char *fault;
    } bad[] = {
        {"x", 0, "'x' is not an integer from 0"},
        {"1.5", 0, "'1.5' is not an integer from 0"},
        {"-1", 0, "'-1' is not an integer from 0"},
        {"0", 1, "'0' is not an integer from 1"},
        {"2147483648", 0,
         "'2147483648' is not an integer from 0 to 2147483647"},
        {"99999999999999999999", 0, "is not an integer from 0 to 2147483647"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        tf_words words = words_of(bad[i].text);
        int number;
        ck_assert(!tf_words_read_integer(&words, bad[i].least, &number));
        expect_fault(1, bad[i].fault);
    }
    tf_words words = words_of("1 2\nnan");
    double x[3];
    const char *at[3];
    ck_assert(!tf_words_read_position(&words, x, at));
    expect_fault(2, "'nan' is not a finite number; ");
    file = empty_mesh("words");
    words = tf_words_of(&file, "a\0b", 3);
    ck_assert(tf_words_take(&words, "a"));
    ck_assert(!tf_words_read_number(&words, x));
    expect_fault(1, "a NUL byte; ");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/words");
    TCase *words = tcase_create("words");
    tcase_add_test(words, ends_of_lines_are_blanks);
    tcase_add_test(words, comments_end_with_their_lines);
    tcase_add_test(words, words_are_skipped);
    tcase_add_test(words, rests_of_lines_are_skipped);
    tcase_add_test(words, numbers_are_read);
    tcase_add_test(words, other_numbers_are_refused);
    suite_add_tcase(suite, words);
    return suite;
}
