#include "files/text_lines.h"

#include "support/program.h"
#include "support/support.h"

#include <string.h>

static tf_fault fault;

static tf_text_lines open_text(const void *text, size_t size)
{
    make_binary_file("text", text, size);
    tf_text_lines lines;
    ck_assert(tf_text_lines_open(&lines, "text", &fault));
    return lines;
}

static void expect_line(tf_text_lines *lines, long line, const char *text)
{
    ck_assert_int_eq(tf_text_lines_next(lines), TF_READ_GOOD);
    ck_assert_int_eq(lines->text.line, line);
    ck_assert_str_eq(lines->text.at, text);
}

static void expect_fault(tf_text_lines *lines, long line, const char *words)
{
    ck_assert_int_eq(tf_text_lines_next(lines), TF_READ_FAULT);
    ck_assert_int_eq(fault.place, line);
    expect_words(fault.text, words);
}

START_TEST(only_lines_that_hold_something_are_read)
{
    static const char text[] = "\xEF\xBB\xBF"
                               "a b\r\n\n \t\n# c\n  #\n\td # e";
    tf_text_lines lines = open_text(text, strlen(text));
    expect_line(&lines, 1, "a b");
    expect_line(&lines, 6, "d # e");
    ck_assert_int_eq(tf_text_lines_next(&lines), TF_READ_END);
    tf_text_lines_close(&lines);
}
END_TEST

START_TEST(blanks_are_skipped)
{
    tf_text_lines lines = open_text(" \ta \t b", 7);
    expect_line(&lines, 1, "a \t b");
    lines.text.at++;
    tf_text_skip_blanks(&lines.text);
    ck_assert_str_eq(lines.text.at, "b");
    lines.text.at++;
    tf_text_skip_blanks(&lines.text);
    ck_assert_str_eq(lines.text.at, "");
    tf_text_lines_close(&lines);
}
END_TEST

START_TEST(an_empty_text_has_no_lines)
{
    tf_text_lines lines = open_text("", 0);
    ck_assert_int_eq(tf_text_lines_next(&lines), TF_READ_END);
    tf_text_lines_close(&lines);
}
END_TEST

START_TEST(a_stream_is_read_and_closed)
{
    make_file("text", "a\nb\n");
    FILE *stream = fopen("text", "r");
    tf_text_lines lines;
    tf_text_lines_start(&lines, stream, "text", &fault);
    expect_line(&lines, 1, "a");
    ck_assert_ptr_eq(lines.stream, stream);
    tf_text_lines_close(&lines);
    ck_assert_ptr_null(lines.stream);
}
END_TEST

START_TEST(unreadable_texts_are_refused)
{
    tf_text_lines lines = open_text("a\nb\0c\n", 6);
    expect_line(&lines, 1, "a");
    expect_fault(&lines, 2, "a NUL byte; ");
    tf_text_lines_close(&lines);
    ck_assert(tf_text_lines_open(&lines, ".", &fault));
    expect_fault(&lines, 1, "cannot read: Is a directory; ");
    tf_text_lines_close(&lines);
    ck_assert(!tf_text_lines_open(&lines, "absent", &fault));
    ck_assert_str_eq(fault.text,
                     "cannot open: No such file or directory; check the name");
    ck_assert_int_lt(fault.place, 0);
    tf_text_lines_close(&lines);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/text_lines");
    TCase *lines = tcase_create("lines");
    tcase_add_checked_fixture(lines, enter_folder, leave_folder);
    tcase_add_test(lines, only_lines_that_hold_something_are_read);
    tcase_add_test(lines, blanks_are_skipped);
    tcase_add_test(lines, an_empty_text_has_no_lines);
    tcase_add_test(lines, a_stream_is_read_and_closed);
    tcase_add_test(lines, unreadable_texts_are_refused);
    suite_add_tcase(suite, lines);
    return suite;
}
