#define _GNU_SOURCE // open_memstream

#include "program/summary.h"

#include "support/json.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>

static char *text;

static void written(int entries, const tf_entry entry[],
                    void (*write)(FILE *, int, const tf_entry[]))
{
    size_t size;
    free(text);
    FILE *stream = open_memstream(&text, &size);
    write(stream, entries, entry);
    fclose(stream);
}

START_TEST(for_people)
{
    const tf_entry entries[] = {tf_entry_word("the status", "good"),
                                tf_entry_count("large count", SIZE_MAX),
                                tf_entry_number("length", 1.0 / 3),
                                tf_entry_number("energy", INFINITY)};
    written(4, entries, tf_summary_write);
    char right[1000];
    snprintf(right, sizeof right,
             "the status: good\nlarge count: %zu\nlength: 0.333333\n"
             "energy: inf\n",
             SIZE_MAX);
    ck_assert_str_eq(text, right);
}
END_TEST

START_TEST(as_json)
{
    const tf_entry entries[] = {
        tf_entry_word("the status", "good"), tf_entry_count("a b c", 0),
        tf_entry_number("length", 0.1), tf_entry_number("energy", INFINITY),
        tf_entry_number("no number", NAN)};
    written(5, entries, tf_summary_write_json);
    ck_assert_str_eq(text, "{\"the_status\":\"good\",\"a_b_c\":0,"
                           "\"length\":0.10000000000000001,\"energy\":null,"
                           "\"no_number\":null}");
    ck_assert_msg(!json_fault(text), "%s", json_fault(text));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/summary");
    TCase *summary = tcase_create("summary");
    tcase_add_test(summary, for_people);
    tcase_add_test(summary, as_json);
    suite_add_tcase(suite, summary);
    return suite;
}
