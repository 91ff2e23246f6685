#include "base/describe.h"

#include "support/support.h"

#include <string.h>

static const tf_error friction = {.status = TF_BAD_OPTION,
                                  .subject = TF_OPTION,
                                  .option = "friction",
                                  .range = "0 or more",
                                  .value = -1};
static const char sentence[] = "friction must be 0 or more, got -1";

START_TEST(sentence_is_cut_off_at_any_size)
{
    char buffer[sizeof sentence + 8];
    memset(buffer, '#', sizeof buffer);
    size_t size = (size_t)_i;
    ck_assert_uint_eq(tf_describe(&friction, size ? buffer : NULL, size),
                      strlen(sentence));
    size_t written = size < sizeof sentence ? size : sizeof sentence;
    if (written > 0) {
        ck_assert_uint_eq(strlen(buffer), written - 1);
        ck_assert_int_eq(strncmp(buffer, sentence, written - 1), 0);
    }
    for (size_t i = written; i < sizeof buffer; i++)
        ck_assert_int_eq(buffer[i], '#');
}
END_TEST

START_TEST(status_alone_has_its_message)
{
    char buffer[256];
    for (int s = TF_OK; s <= TF_IN_USE; s++) {
        tf_error error = {.status = (tf_status)s};
        tf_describe(&error, buffer, sizeof buffer);
        ck_assert_str_eq(buffer, tf_status_message((tf_status)s));
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/describe");
    TCase *tcase = tcase_create("describe");
    tcase_add_loop_test(tcase, sentence_is_cut_off_at_any_size, 0,
                        (int)sizeof sentence + 8);
    tcase_add_test(tcase, status_alone_has_its_message);
    suite_add_tcase(suite, tcase);
    return suite;
}
