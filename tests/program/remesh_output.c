#define _GNU_SOURCE // open_memstream

#include "program/remesh_output.h"

#include "support/support.h"

#include <stdlib.h>
#include <string.h>

static char *write_report(tf_format format)
{
    tf_remeshed of = {.triangles_before = 3,
                      .triangles_after = 4,
                      .edge = 0.5,
                      .seconds = 0.125};
    of.report = (tf_remesh_report){.rounds = 2,
                                   .least_before = 0.25,
                                   .least_after = 0.375,
                                   .mean_before = 0.75,
                                   .mean_after = 0.875,
                                   .distance = 1.5};
    for (int i = 0; i < TF_OPERATIONS; i++)
        for (int j = 0; j < TF_OUTCOMES; j++)
            of.report.tried[i][j] = (size_t)(100 * (i + 1) + j);
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    ck_assert(tf_remesh_output_write(stream, format, &of));
    fclose(stream);
    return text;
}

START_TEST(a_summary_has_a_line_for_each_number)
{
    static const char own[] =
        "triangles before: 3\ntriangles: 4\nedge: 0.5\n"
        "least quality before: 0.25\nleast quality: 0.375\n"
        "mean quality before: 0.75\nmean quality: 0.875\ndistance: 1.5\n"
        "rounds: 2\nseconds: 0.125\n"
        "splits: 101\nimpossible splits: 102\n";
    char *text = write_report(TF_SUMMARY);
    ck_assert_int_eq(strncmp(text, own, strlen(own)), 0);
    ck_assert_ptr_nonnull(strstr(text, "\ncollapses past edges: 206\n"));
    ck_assert_ptr_nonnull(strstr(text, "\nmoves past triangles: 407\n"));
    free(text);
}
END_TEST

START_TEST(json_has_a_member_for_each_number)
{
    char *text = write_report(TF_JSON);
    ck_assert_ptr_nonnull(strstr(text, "\"least_quality_before\":0.25"));
    ck_assert_ptr_nonnull(strstr(text, "\"overlapping_flips\":304"));
    ck_assert_ptr_nonnull(strstr(text, "}\n"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/remesh_output");
    TCase *tcase = tcase_create("reports");
    tcase_add_test(tcase, a_summary_has_a_line_for_each_number);
    tcase_add_test(tcase, json_has_a_member_for_each_number);
    suite_add_tcase(suite, tcase);
    return suite;
}
