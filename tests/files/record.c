// Records in all formats, to the letter.
#define _GNU_SOURCE // open_memstream, fopencookie

#include "files/record.h"

#include "support/json.h"
#include "support/support.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

/// A member of each type.
typedef struct sample {
    size_t count;
    int integer;
    double number, rounded;
    const char *word;
} sample;

static const tf_field fields[] = {
    TF_FIELD("a count", sample, count),
    TF_FIELD("integer", sample, integer),
    TF_FIELD("number", sample, number),
    {"rounded", TF_NUMBER, offsetof(sample, rounded), "%.2f"},
    {"empty", TF_EMPTY, 0, NULL},
    TF_FIELD("word", sample, word),
    {0},
};

static const sample full = {SIZE_MAX, 7, 1.0 / 3, 0.125, "good"};
static const sample none = {0, -1, NAN, NAN, NULL};
static const sample infinite = {1, 0, INFINITY, -INFINITY, ""};

static char *text;
static size_t length;

static void expect_text(FILE *stream, const char *right)
{
    fclose(stream);
    ck_assert_str_eq(text, right);
    free(text);
}

static void expect_record(void (*write)(FILE *, const tf_field *, const void *),
                          const sample *record, const char *right)
{
    FILE *stream = open_memstream(&text, &length);
    write(stream, fields, record);
    expect_text(stream, right);
}

static const char *full_with(const char *format)
{
    static char filled[200];
    snprintf(filled, sizeof filled, format, SIZE_MAX);
    return filled;
}

// A record --------------------------------------------------------------------

START_TEST(csv_has_all_digits_and_nothing_where_there_is_no_value)
{
    FILE *stream = open_memstream(&text, &length);
    tf_record_write_head(stream, fields);
    expect_text(stream, "a_count,integer,number,rounded,empty,word\n");
    expect_record(tf_record_write_csv, &full,
                  full_with("%zu,7,0.33333333333333331,0.12,,good\n"));
    expect_record(tf_record_write_csv, &none, "0,,,,,\n");
    expect_record(tf_record_write_csv, &infinite, "1,0,inf,-inf,,\n");
}
END_TEST

START_TEST(json_has_all_digits_and_null_where_there_is_no_value)
{
    expect_record(tf_record_write_json, &full,
                  full_with("{\"a_count\":%zu,\"integer\":7,\"number\":"
                            "0.33333333333333331,\"rounded\":0.125,"
                            "\"word\":\"good\"}"));
    static const char null[] =
        "{\"a_count\":0,\"integer\":null,\"number\":null,"
        "\"rounded\":null,\"word\":null}";
    expect_record(tf_record_write_json, &none, null);
    ck_assert_msg(!json_fault(null), "%s", json_fault(null));
    expect_record(tf_record_write_json, &infinite,
                  "{\"a_count\":1,\"integer\":0,\"number\":null,"
                  "\"rounded\":null,\"word\":\"\"}");
}
END_TEST

START_TEST(lines_are_of_fields_with_a_value)
{
    expect_record(tf_record_write_lines, &full,
                  full_with("a count: %zu\ninteger: 7\nnumber: 0.333333\n"
                            "rounded: 0.125\nword: good\n"));
    expect_record(tf_record_write_lines, &none, "a count: 0\n");
    expect_record(tf_record_write_lines, &infinite,
                  "a count: 1\ninteger: 0\nnumber: inf\nrounded: -inf\n"
                  "word: \n");
}
END_TEST

/// Words, as fields of CSV and as strings of JSON.
static const struct {
    const char *word, *csv, *json;
} words[] = {
    {"a b.obj", "a b.obj", "\"a b.obj\""},
    {"a,b", "\"a,b\"", "\"a,b\""},
    {"a\"b", "\"a\"\"b\"", "\"a\\\"b\""},
    {"\"", "\"\"\"\"", "\"\\\"\""},
    {"a\nb", "\"a\nb\"", "\"a\\\\x0ab\""},
    {"a\rb", "\"a\rb\"", "\"a\\\\x0db\""},
    {"a\\b", "a\\b", "\"a\\\\b\""},
    {"\x1b\x01", "\x1b\x01", "\"\\\\x1b\\\\x01\""},
    {"\xc3\xa9", "\xc3\xa9", "\"\xc3\xa9\""},
    {"\xff\xc3", "\xff\xc3", "\"\\\\xff\\\\xc3\""},
    {"%s%n", "%s%n", "\"%s%n\""},
    {"", "", "\"\""},
};

START_TEST(words_are_quoted_as_the_format_requires)
{
    const sample s = {0, 0, 0, 0, words[_i].word};
    char right[200];
    snprintf(right, sizeof right, "0,0,0,0.00,,%s\n", words[_i].csv);
    expect_record(tf_record_write_csv, &s, right);
    snprintf(right, sizeof right,
             "{\"a_count\":0,\"integer\":0,\"number\":0,\"rounded\":0,"
             "\"word\":%s}",
             words[_i].json);
    ck_assert_msg(!json_fault(right), "%s", json_fault(right));
    expect_record(tf_record_write_json, &s, right);
}
END_TEST

START_TEST(a_report_is_lines_or_an_object_or_a_table)
{
    FILE *stream = open_memstream(&text, &length);
    ck_assert(tf_report_write(stream, TF_SUMMARY, fields, &none));
    ck_assert(tf_report_write(stream, TF_JSON, fields, &none));
    expect_text(stream, "a count: 0\n"
                        "{\"a_count\":0,\"integer\":null,\"number\":null,"
                        "\"rounded\":null,\"word\":null}\n");
    stream = open_memstream(&text, &length);
    ck_assert(tf_report_write(stream, TF_CSV, fields, &infinite));
    expect_text(stream, "a_count,integer,number,rounded,empty,word\n"
                        "1,0,inf,-inf,,\n");
}
END_TEST

static const tf_field first[] = {TF_FIELD("first", sample, integer), {0}};

START_TEST(joined_fields_are_in_order)
{
    tf_field all[8];
    tf_fields_join(all, first, fields);
    FILE *stream = open_memstream(&text, &length);
    tf_record_write_head(stream, all);
    expect_text(stream, "first,a_count,integer,number,rounded,empty,word\n");
}
END_TEST

// Many records ----------------------------------------------------------------

typedef struct row {
    int x;
} row;

static const tf_field x_field[] = {TF_FIELD("x", row, x), {0}};

/// Expects the text of some records, with their number as the summary.
static void expect_records(tf_format format, const char *name, int count,
                           const char *right)
{
    FILE *stream = open_memstream(&text, &length);
    tf_records records;
    tf_records_begin(&records, stream, format, name, x_field);
    for (int i = 0; i < count; i++)
        ck_assert(tf_records_add(&records, &(row){i}));
    ck_assert_uint_eq(records.count, (size_t)count);
    ck_assert(tf_records_end(&records, x_field, &(row){count}));
    expect_text(stream, right);
}

START_TEST(each_format_has_its_frame)
{
    expect_records(TF_CSV, "rows", 0, "x\n");
    expect_records(TF_CSV, NULL, 2, "x\n0\n1\n");
    expect_records(TF_JSON, NULL, 0, "[\n]\n");
    expect_records(TF_JSON, NULL, 2, "[\n{\"x\":0},\n{\"x\":1}\n]\n");
    expect_records(TF_JSON, "rows", 0,
                   "{\"rows\":[\n],\n\"summary\":{\"x\":0}}\n");
    expect_records(TF_JSON, "rows", 2,
                   "{\"rows\":[\n{\"x\":0},\n{\"x\":1}\n],\n"
                   "\"summary\":{\"x\":2}}\n");
    expect_records(TF_SUMMARY, "rows", 2, "x: 2\n");
}
END_TEST

START_TEST(an_end_without_a_summary_writes_none)
{
    FILE *stream = open_memstream(&text, &length);
    tf_records records;
    tf_records_begin(&records, stream, TF_SUMMARY, NULL, x_field);
    ck_assert(tf_records_add(&records, &(row){1}));
    ck_assert(tf_records_end(&records, NULL, NULL));
    expect_text(stream, "");
}
END_TEST

// Full disks ------------------------------------------------------------------

START_TEST(a_full_disk_is_noticed_at_the_end)
{
    FILE *stream = fopen("/dev/full", "w");
    tf_records records;
    tf_records_begin(&records, stream, TF_CSV, NULL, x_field);
    ck_assert(!tf_records_end(&records, NULL, NULL));
    ck_assert_int_eq(records.error, ENOSPC);
    ck_assert(!tf_report_write(stream, TF_JSON, x_field, &(row){1}));
    fclose(stream);
}
END_TEST

START_TEST(a_full_disk_is_noticed_on_the_way)
{
    FILE *stream = fopen("/dev/full", "w");
    tf_records records;
    tf_records_begin(&records, stream, TF_JSON, NULL, x_field);
    bool good = true;
    for (int i = 0; i < 100000 && good; i++)
        good = tf_records_add(&records, &(row){i});
    ck_assert(!good);
    ck_assert_int_eq(records.error, ENOSPC);
    errno = 0;
    ck_assert(!tf_records_end(&records, NULL, NULL));
    ck_assert_int_eq(records.error, ENOSPC);
    fclose(stream);
}
END_TEST

/// Fails for another reason each time.
static ssize_t fail_to_write(void *reason, const char *bytes, size_t size)
{
    (void)bytes;
    (void)size;
    errno = ++*(int *)reason;
    return 0;
}

START_TEST(the_first_reason_counts)
{
    int reason = ENOENT;
    cookie_io_functions_t functions = {.write = fail_to_write};
    FILE *stream = fopencookie(&reason, "w", functions);
    setvbuf(stream, NULL, _IONBF, 0);
    tf_records records;
    tf_records_begin(&records, stream, TF_JSON, NULL, x_field);
    ck_assert(!tf_records_add(&records, &(row){1}));
    ck_assert_int_eq(records.error, ENOENT + 1);
    ck_assert(!tf_records_end(&records, NULL, NULL));
    ck_assert_int_eq(records.error, ENOENT + 1);
    fclose(stream);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/record");
    TCase *record = tcase_create("a record");
    tcase_add_test(record,
                   csv_has_all_digits_and_nothing_where_there_is_no_value);
    tcase_add_test(record,
                   json_has_all_digits_and_null_where_there_is_no_value);
    tcase_add_test(record, lines_are_of_fields_with_a_value);
    tcase_add_loop_test(record, words_are_quoted_as_the_format_requires, 0,
                        sizeof words / sizeof *words);
    tcase_add_test(record, a_report_is_lines_or_an_object_or_a_table);
    tcase_add_test(record, joined_fields_are_in_order);
    suite_add_tcase(suite, record);

    TCase *many = tcase_create("many records");
    tcase_add_test(many, each_format_has_its_frame);
    tcase_add_test(many, an_end_without_a_summary_writes_none);
    suite_add_tcase(suite, many);

    TCase *disks = tcase_create("full disks");
    tcase_add_test(disks, a_full_disk_is_noticed_at_the_end);
    tcase_add_test(disks, a_full_disk_is_noticed_on_the_way);
    tcase_add_test(disks, the_first_reason_counts);
    suite_add_tcase(suite, disks);
    return suite;
}
