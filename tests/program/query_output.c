#define _GNU_SOURCE // open_memstream

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
static char *written(tf_format format, int axes,
                     const tf_contact *const contact[], const int truth[])
{
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    tf_query_output output;
    tf_query_output_begin(&output, stream, format, axes);
    for (int i = 0; contact[i]; i++) {
        tf_query_rows query = {.ground_truth = truth ? truth[i] : -1};
        ck_assert(tf_query_output_answer(&output, &query, contact[i]));
    }
    ck_assert(tf_query_output_end(&output));
    fclose(stream);
    return text;
}

static void expect(tf_format format, int axes,
                   const tf_contact *const contact[], const int truth[],
                   const char *right)
{
    char *text = written(format, axes, contact, truth);
    ck_assert_str_eq(text, right);
    free(text);
}

static const tf_contact *const none[] = {NULL};
static const tf_contact *const some[] = {&hit, &apart, &undecided, NULL};

START_TEST(csv_of_no_queries_is_the_heading)
{
    expect(TF_CSV, 3, none, NULL,
           "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n");
}
END_TEST

START_TEST(csv_has_a_row_for_each_query)
{
    expect(TF_CSV, 3, some, NULL,
           "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"
           "0,1,0.25,0.10000000000000001,1,-0.5,2.999966601548049e-320,"
           "-1.7976931348623157e+308,degenerate\n"
           "1,0,,,,,,,\n"
           "2,1,0,0,0,0,0,0,touching\n");
}
END_TEST

START_TEST(csv_has_no_nz_in_the_plane)
{
    expect(TF_CSV, 2, some, NULL,
           "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"
           "0,1,0.25,0.10000000000000001,1,-0.5,,-1.7976931348623157e+308,"
           "degenerate\n"
           "1,0,,,,,,,\n"
           "2,1,0,0,0,0,,0,touching\n");
}
END_TEST

START_TEST(json_of_no_queries_is_an_empty_array)
{
    expect(TF_JSON, 3, none, NULL, "[\n]\n");
}
END_TEST

START_TEST(json_has_null_where_there_is_no_value)
{
    expect(TF_JSON, 2, some, NULL,
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

START_TEST(a_summary_counts_hits_by_case)
{
    expect(TF_SUMMARY, 3, some, NULL,
           "queries: 3\nhits: 2\ngeneric: 0\ntouching: 1\ndegenerate: 1\n");
}
END_TEST

START_TEST(a_summary_compares_with_the_truth)
{
    static const tf_contact generic = {.verdict = TF_HIT,
                                       .classification = TF_GENERIC};
    const tf_contact *contact[] = {&generic, &hit,   &hit,   &undecided,
                                   &apart,   &apart, &apart, NULL};
    static const int truth[] = {1, 0, 0, -1, 0, 1, -1};
    expect(TF_SUMMARY, 3, contact, truth,
           "queries: 7\nhits: 4\ngeneric: 1\ntouching: 1\ndegenerate: 2\n"
           "agree: 2\nextra: 2\nmissed: 1\n");
}
END_TEST

START_TEST(a_summary_compares_two_methods)
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
    tf_query_output_begin(&output, stream, TF_SUMMARY, 3);
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

START_TEST(a_full_disk_is_noticed)
{
    FILE *stream = fopen("/dev/full", "w");
    tf_query_output output;
    tf_query_rows query = {.ground_truth = -1};
    tf_query_output_begin(&output, stream, TF_JSON, 3);
    bool good = true;
    for (int i = 0; i < 100000 && good; i++)
        good = tf_query_output_answer(&output, &query, &hit);
    ck_assert(!good);
    ck_assert(!tf_query_output_end(&output));
    ck_assert_int_eq(output.records.error, ENOSPC);
    fclose(stream);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/query_output");
    TCase *formats = tcase_create("formats");
    tcase_add_test(formats, csv_of_no_queries_is_the_heading);
    tcase_add_test(formats, csv_has_a_row_for_each_query);
    tcase_add_test(formats, csv_has_no_nz_in_the_plane);
    tcase_add_test(formats, json_of_no_queries_is_an_empty_array);
    tcase_add_test(formats, json_has_null_where_there_is_no_value);
    tcase_add_test(formats, a_summary_counts_hits_by_case);
    tcase_add_test(formats, a_summary_compares_with_the_truth);
    tcase_add_test(formats, a_summary_compares_two_methods);
    tcase_add_test(formats, a_full_disk_is_noticed);
    suite_add_tcase(suite, formats);
    return suite;
}
