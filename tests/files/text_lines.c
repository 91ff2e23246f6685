#include "files/text_lines.h"

#include "support/program.h"
#include "support/support.h"

#include <string.h>

static tf_text_lines open_text(const void *text, size_t size)
{
    make_binary_file("text", text, size);
    tf_text_lines lines;
    ck_assert(tf_text_lines_open(&lines, "text"));
    return lines;
}

static void expect_line(tf_text_lines *lines, long line, const char *text)
{
    ck_assert_int_eq(tf_text_lines_next(lines), TF_READ_GOOD);
    ck_assert_int_eq(lines->line, line);
    ck_assert_str_eq(lines->at, text);
}

static void expect_fault(tf_text_lines *lines, long line, const char *words)
{
    ck_assert_int_eq(tf_text_lines_next(lines), TF_READ_FAULT);
    ck_assert_int_eq(lines->fault_line, line);
    expect_words(lines->fault, words);
}

START_TEST(lines_that_hold_something)
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
    lines.at++;
    tf_text_lines_skip_blanks(&lines);
    ck_assert_str_eq(lines.at, "b");
    lines.at++;
    tf_text_lines_skip_blanks(&lines);
    ck_assert_str_eq(lines.at, "");
    tf_text_lines_close(&lines);
}
END_TEST

START_TEST(an_empty_text)
{
    tf_text_lines lines = open_text("", 0);
    ck_assert_int_eq(tf_text_lines_next(&lines), TF_READ_END);
    tf_text_lines_close(&lines);
}
END_TEST

START_TEST(a_stream)
{
    make_file("text", "a\nb\n");
    FILE *stream = fopen("text", "r");
    tf_text_lines lines;
    tf_text_lines_start(&lines, stream, "text");
    expect_line(&lines, 1, "a");
    ck_assert_ptr_eq(lines.stream, stream);
    tf_text_lines_close(&lines);
    ck_assert_ptr_null(lines.stream);
}
END_TEST

START_TEST(texts_that_cannot_be_read)
{
    tf_text_lines lines = open_text("a\nb\0c\n", 6);
    expect_line(&lines, 1, "a");
    expect_fault(&lines, 2, "a NUL byte; ");
    tf_text_lines_close(&lines);
    ck_assert(tf_text_lines_open(&lines, "."));
    expect_fault(&lines, 1, "cannot read: Is a directory; ");
    tf_text_lines_close(&lines);
    ck_assert(!tf_text_lines_open(&lines, "absent"));
    ck_assert_str_eq(lines.fault,
                     "cannot open: No such file or directory; check the name");
    ck_assert_int_eq(lines.fault_line, 0);
    tf_text_lines_close(&lines);
}
END_TEST

START_TEST(faults_are_printed_with_their_place)
{
    tf_text_lines lines;
    tf_text_lines_start(&lines, NULL, "a\x1b");
    ck_assert(freopen("printed", "w", stderr));
    ck_assert(!tf_text_lines_fault(&lines, 3, "%d is %s", 7, "odd"));
    tf_text_lines_print_fault(&lines, "program");
    ck_assert(!tf_text_lines_fault(&lines, 0, "bad"));
    tf_text_lines_print_fault(&lines, "program");
    fflush(stderr);
    ck_assert_str_eq(file_text("printed"), "program: a\\x1b:3: 7 is odd\n"
                                           "program: a\\x1b: bad\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/text_lines");
    TCase *lines = tcase_create("lines");
    tcase_add_checked_fixture(lines, enter_folder, leave_folder);
    tcase_add_test(lines, lines_that_hold_something);
    tcase_add_test(lines, blanks_are_skipped);
    tcase_add_test(lines, an_empty_text);
    tcase_add_test(lines, a_stream);
    tcase_add_test(lines, texts_that_cannot_be_read);
    tcase_add_test(lines, faults_are_printed_with_their_place);
    suite_add_tcase(suite, lines);
    return suite;
}
