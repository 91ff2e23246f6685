#define _GNU_SOURCE // open_memstream, fopencookie

#include "program/query_output.h"

#include "support/support.h"

#include <errno.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

static const tf_contact hit = {
    .verdict = TF_HIT,
    .classification = TF_DEGENERATE,
    .toi_lo = 0.25,
    .toi_hi = 0.1,
    .normal = {1, -0.5, 3e-320},
    .normal_velocity = -DBL_MAX,
};
static const tf_contact undecided = {.verdict = TF_UNDECIDED,
                                     .classification = TF_TOUCHING};
// What a query leaves unset must not be read.
static const tf_contact apart = {
    .verdict = TF_APART, .classification = (tf_classification)99, .toi_lo = 7};

/// The output of these contacts, NULL the last, of these truths.
static char *written(const char *format, int axes,
                     const tf_contact *const contact[], const int truth[])
{
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    tf_query_output output;
    ck_assert(tf_query_output_begin(&output, stream,
                                    tf_query_format_named(format), axes));
    for (int i = 0; contact[i]; i++) {
        tf_query_rows query = {.ground_truth = truth ? truth[i] : -1};
        ck_assert(tf_query_output_answer(&output, &query, contact[i]));
    }
    ck_assert(tf_query_output_end(&output));
    fclose(stream);
    return text;
}

static void expect(const char *format, int axes,
                   const tf_contact *const contact[], const int truth[],
                   const char *right)
{
    char *text = written(format, axes, contact, truth);
    ck_assert_str_eq(text, right);
    free(text);
}

static const tf_contact *const none[] = {NULL};
static const tf_contact *const some[] = {&hit, &apart, &undecided, NULL};

START_TEST(csv_of_nothing)
{
    expect("csv", 3, none, NULL,
           "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n");
}
END_TEST

START_TEST(csv_in_space)
{
    expect("csv", 3, some, NULL,
           "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"
           "0,1,0.25,0.10000000000000001,1,-0.5,2.999966601548049e-320,"
           "-1.7976931348623157e+308,degenerate\n"
           "1,0,,,,,,,\n"
           "2,1,0,0,0,0,0,0,touching\n");
}
END_TEST

START_TEST(csv_in_the_plane)
{
    expect("csv", 2, some, NULL,
           "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"
           "0,1,0.25,0.10000000000000001,1,-0.5,,-1.7976931348623157e+308,"
           "degenerate\n"
           "1,0,,,,,,,\n"
           "2,1,0,0,0,0,,0,touching\n");
}
END_TEST

START_TEST(json_of_nothing)
{
    expect("json", 3, none, NULL, "[\n]\n");
}
END_TEST

START_TEST(json_of_some)
{
    expect("json", 2, some, NULL,
           "[\n"
           "{\"query\":0,\"hit\":1,\"toi_lo\":0.25,"
           "\"toi_hi\":0.10000000000000001,\"nx\":1,\"ny\":-0.5,\"nz\":null,"
           "\"normal_velocity\":-1.7976931348623157e+308,\"case\":"
           "\"degenerate\"},\n"
           "{\"query\":1,\"hit\":0,\"toi_lo\":null,\"toi_hi\":null,"
           "\"nx\":null,\"ny\":null,\"nz\":null,\"normal_velocity\":null,"
           "\"case\":null},\n"
           "{\"query\":2,\"hit\":1,\"toi_lo\":0,\"toi_hi\":0,\"nx\":0,"
           "\"ny\":0,\"nz\":null,\"normal_velocity\":0,\"case\":\"touching\"}\n"
           "]\n");
}
END_TEST

START_TEST(summary_without_truth)
{
    expect("summary", 3, some, NULL,
           "queries: 3\nhits: 2\ngeneric: 0\ntouching: 1\ndegenerate: 1\n");
}
END_TEST

START_TEST(summary_with_truth)
{
    static const tf_contact generic = {.verdict = TF_HIT,
                                       .classification = TF_GENERIC};
    const tf_contact *contact[] = {&generic, &hit,   &hit,   &undecided,
                                   &apart,   &apart, &apart, NULL};
    static const int truth[] = {1, 0, 0, -1, 0, 1, -1};
    expect("summary", 3, contact, truth,
           "queries: 7\nhits: 4\ngeneric: 1\ntouching: 1\ndegenerate: 2\n"
           "agree: 2\nextra: 2\nmissed: 1\n");
}
END_TEST

START_TEST(summary_of_two_methods)
{
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    tf_query_output output;
    tf_query_rows query = {.ground_truth = -1};
    const tf_contact *pairs[][2] = {{&hit, &apart},
                                    {&undecided, &apart},
                                    {&apart, &hit},
                                    {&hit, &hit},
                                    {&apart, &apart}};
    tf_query_output_begin(&output, stream, tf_query_format_named("summary"), 3);
    for (int i = 0; i < 5; i++) {
        tf_query_output_compare(&output, pairs[i][0], pairs[i][1]);
        tf_query_output_answer(&output, &query, pairs[i][0]);
    }
    tf_query_output_end(&output);
    fclose(stream);
    ck_assert_str_eq(text, "queries: 5\nhits: 3\ngeneric: 0\ntouching: 1\n"
                           "degenerate: 2\ndiffer: 3\nonly_method: 2\n"
                           "only_against: 1\n");
    free(text);
}
END_TEST

START_TEST(formats_by_their_names)
{
    ck_assert_ptr_null(tf_query_format_named(""));
    ck_assert_ptr_null(tf_query_format_named("xml"));
    char names[] = TF_QUERY_FORMAT_NAMES;
    int found = 0;
    char *rest = names;
    for (char *name; (name = strtok_r(rest, ", ", &rest));)
        found += tf_query_format_named(name) != NULL;
    ck_assert_int_eq(found, 3);
}
END_TEST

START_TEST(full_disk_at_the_end)
{
    FILE *stream = fopen("/dev/full", "w");
    tf_query_output output;
    ck_assert(tf_query_output_begin(&output, stream,
                                    tf_query_format_named("csv"), 3));
    ck_assert(!tf_query_output_end(&output));
    ck_assert_int_eq(output.error, ENOSPC);
    fclose(stream);
}
END_TEST

START_TEST(full_disk_on_the_way)
{
    FILE *stream = fopen("/dev/full", "w");
    tf_query_output output;
    tf_query_rows query = {.ground_truth = -1};
    tf_query_output_begin(&output, stream, tf_query_format_named("json"), 3);
    bool good = true;
    for (int i = 0; i < 100000 && good; i++)
        good = tf_query_output_answer(&output, &query, &hit);
    ck_assert(!good);
    ck_assert_int_eq(output.error, ENOSPC);
    errno = 0;
    ck_assert(!tf_query_output_end(&output));
    ck_assert_int_eq(output.error, ENOSPC);
    fclose(stream);
}
END_TEST

/// Fail for another reason each time.
static ssize_t fail_to_write(void *reason, const char *text, size_t length)
{
    (void)text;
    (void)length;
    errno = ++*(int *)reason;
    return 0;
}

START_TEST(the_first_reason_counts)
{
    int reason = ENOENT;
    cookie_io_functions_t functions = {.write = fail_to_write};
    FILE *stream = fopencookie(&reason, "w", functions);
    setvbuf(stream, NULL, _IONBF, 0);
    tf_query_output output;
    ck_assert(!tf_query_output_begin(&output, stream,
                                     tf_query_format_named("json"), 3));
    ck_assert_int_eq(output.error, ENOENT + 1);
    ck_assert(!tf_query_output_end(&output));
    ck_assert_int_eq(output.error, ENOENT + 1);
    fclose(stream);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/query_output");
    TCase *formats = tcase_create("formats");
    tcase_add_test(formats, csv_of_nothing);
    tcase_add_test(formats, csv_in_space);
    tcase_add_test(formats, csv_in_the_plane);
    tcase_add_test(formats, json_of_nothing);
    tcase_add_test(formats, json_of_some);
    tcase_add_test(formats, summary_without_truth);
    tcase_add_test(formats, summary_with_truth);
    tcase_add_test(formats, summary_of_two_methods);
    tcase_add_test(formats, formats_by_their_names);
    suite_add_tcase(suite, formats);

    TCase *full = tcase_create("a full disk");
    tcase_add_test(full, full_disk_at_the_end);
    tcase_add_test(full, full_disk_on_the_way);
    tcase_add_test(full, the_first_reason_counts);
    suite_add_tcase(suite, full);
    return suite;
}
