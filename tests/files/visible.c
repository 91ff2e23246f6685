#include "files/visible.h"

#include "support/support.h"

#include <string.h>

static void expect(const char *name, const char *shown)
{
    tf_visible visible = tf_make_visible(name);
    ck_assert_str_eq(visible.text, shown);
}

START_TEST(plain_names_stay)
{
    static const char *const names[] = {"",
                                        "a",
                                        "folder/a file.csv",
                                        "back\\slash",
                                        "~",
                                        "caf\xc3\xa9",
                                        "\xc2\xa0",
                                        "\xe2\x82\xac",
                                        "\xef\xbf\xbd",
                                        "\xf0\x9f\x99\x82",
                                        "\xf4\x8f\xbf\xbf"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        expect(names[i], names[i]);
}
END_TEST

START_TEST(control_characters_are_shown)
{
    expect("\x1b[2J", "\\x1b[2J");
    expect("a\nb\tc\rd", "a\\x0ab\\x09c\\x0dd");
    expect("\x01\x1f\x7f", "\\x01\\x1f\\x7f");

    // The control sequence introducer in one character.
    expect("\xc2\x9b", "\\xc2\\x9b");
    expect("\xc2\x80", "\\xc2\\x80");
}
END_TEST

START_TEST(what_is_no_utf_8_is_shown)
{
    expect("\x9b", "\\x9b");
    expect("\xff"
           "a",
           "\\xffa");
    expect("\xc3", "\\xc3");
    expect("\xe2\x82", "\\xe2\\x82");
    expect("\xe2\x82"
           "a",
           "\\xe2\\x82a");
    expect("\xc3(", "\\xc3(");
    // Longer than it must be: a slash, an escape.
    expect("\xc0\xaf", "\\xc0\\xaf");
    expect("\xe0\x80\x9b", "\\xe0\\x80\\x9b");
    expect("\xf0\x80\x80\x9b", "\\xf0\\x80\\x80\\x9b");
    // A surrogate, and what is beyond the last character.
    expect("\xed\xa0\x80", "\\xed\\xa0\\x80");
    expect("\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80");
    expect("\xf8\x88\x80\x80\x80", "\\xf8\\x88\\x80\\x80\\x80");
}
END_TEST

START_TEST(long_names_are_cut)
{
    static char name[3 * TF_VISIBLE_ROOM];
    for (int i = 0; i < 2; i++) {
        memset(name, i ? 'a' : '\x1b', sizeof name - 1);
        tf_visible visible = tf_make_visible(name);
        size_t length = strlen(visible.text);
        ck_assert_uint_gt(length, TF_VISIBLE_ROOM - 16);
        ck_assert_str_eq(visible.text + length - 3, "...");
    }
}
END_TEST

START_TEST(words_are_quoted)
{
    static const char word[] = "0123456789012345678901234567890123456789";
    ck_assert_str_eq(tf_quote("word and more", 4).text, "word");
    ck_assert_str_eq(tf_quote("", 0).text, "");
    ck_assert_str_eq(tf_quote("a\x1b\xc3\xa9~ ", 6).text, "a???~ ");
    ck_assert_str_eq(tf_quote(word, 31).text,
                     "0123456789012345678901234567890");
    ck_assert_str_eq(tf_quote(word, 32).text,
                     "0123456789012345678901234567...");
    ck_assert_str_eq(tf_quote(word, 40).text,
                     "0123456789012345678901234567...");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/visible");
    TCase *names = tcase_create("names");
    tcase_add_test(names, plain_names_stay);
    tcase_add_test(names, control_characters_are_shown);
    tcase_add_test(names, what_is_no_utf_8_is_shown);
    tcase_add_test(names, long_names_are_cut);
    tcase_add_test(names, words_are_quoted);
    suite_add_tcase(suite, names);
    return suite;
}
