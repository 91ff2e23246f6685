#include "files/text.h"

#include "support/program.h"
#include "support/support.h"

#include <string.h>

static tf_fault fault;

static tf_text text_of(const char *at)
{
    return (tf_text){.name = "a", .at = at, .line = 5, .fault = &fault};
}

START_TEST(the_mark_of_utf_8_is_no_text)
{
    ck_assert_str_eq(tf_text_begin("\xEF\xBB\xBF"
                                   "a"),
                     "a");
    ck_assert_str_eq(tf_text_begin("\xEF\xBB"
                                   "a"),
                     "\xEF\xBB"
                     "a");
    ck_assert_str_eq(tf_text_begin(""), "");
}
END_TEST

START_TEST(words_are_quoted)
{
    static const struct {
        const char *word, *fault;
    } words[] = {
        {"word", "'word' is bad; mend it"},
        {"a\x1b\x7f\xff", "'a\?\?\?' is bad; mend it"},
        {"1234567890123456789012345678901",
         "'1234567890123456789012345678901' is bad; mend it"},
        {"12345678901234567890123456789012",
         "'1234567890123456789012345678...' is bad; mend it"},
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        tf_text text = text_of(words[i].word);
        ck_assert(!tf_text_fault_in_word(&text, text.at, strlen(text.at),
                                         "bad; mend it"));
        ck_assert_str_eq(fault.text, words[i].fault);
        ck_assert_int_eq(fault.place, 5);
        ck_assert_str_eq(fault.file, "a");
    }
    tf_text text = text_of("");
    ck_assert(!tf_text_fault_in_word(&text, text.at, 0, "bad"));
    expect_words(fault.text, "a NUL byte; ");
}
END_TEST

START_TEST(blanks_are_skipped)
{
    tf_text text = text_of(" \t\r x \n");
    tf_text_skip_blanks(&text);
    ck_assert_str_eq(text.at, "x \n");
    text.at++;
    tf_text_skip_blanks(&text);
    ck_assert_str_eq(text.at, "\n");
}
END_TEST

START_TEST(numbers_end_where_words_do)
{
    double number = 0;
    tf_text text = text_of("0x1p-2;1e1 ");
    ck_assert(tf_text_read_number(&text, ";", &number));
    ck_assert_double_eq(number, 0.25);
    ck_assert_str_eq(text.at, ";1e1 ");
    text.at++;
    ck_assert(!tf_text_read_number(&text, ";", &number));
    ck_assert_str_eq(fault.text, "'1e1' is not a finite number; write a "
                                 "decimal or a hexadecimal float");
    text = text_of("-3");
    ck_assert(tf_text_read_number(&text, "", &number));
    ck_assert_double_eq(number, -3);
}
END_TEST

START_TEST(numbers_that_are_not_finite_are_refused)
{
    static const char *const words[] = {"nan", "inf", "-inf", "x", "", "1e999"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        double number;
        tf_text text = text_of(words[i]);
        ck_assert_msg(!tf_text_read_number(&text, " ", &number), "%s",
                      words[i]);
        expect_words(fault.text, i < 4    ? "not a finite number; "
                                 : i == 4 ? "a NUL byte; "
                                          : "beyond the largest double; ");
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/text");
    TCase *words = tcase_create("words");
    tcase_add_test(words, the_mark_of_utf_8_is_no_text);
    tcase_add_test(words, words_are_quoted);
    tcase_add_test(words, blanks_are_skipped);
    tcase_add_test(words, numbers_end_where_words_do);
    tcase_add_test(words, numbers_that_are_not_finite_are_refused);
    suite_add_tcase(suite, words);
    return suite;
}
