// The reports of changes, to the letter.
#define _GNU_SOURCE // open_memstream

#include "program/reports.h"

#include "support/json.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

static char *text;

static void write_record(tf_format format, const tf_field field[],
                         const void *record)
{
    size_t size;
    free(text);
    FILE *stream = open_memstream(&text, &size);
    ck_assert(tf_report_write(stream, format, field, record));
    fclose(stream);
}

// Responses -------------------------------------------------------------------

/// Every number is another one.
static const tf_resolved resolved = {.status = "resolved",
                                     .seconds = 0.125,
                                     .report =
                                         {
                                             .first_contacts = 1,
                                             .contacts = 2,
                                             .rounds = {3, 4, 5, 6},
                                             .constraints = 7,
                                             .zones = 8,
                                             .largest_zone = 9,
                                             .iterations = 10,
                                             .violation = 0.25,
                                             .smallest_gap = 0.5,
                                             .groups = 11,
                                             .grouped = 12,
                                             .resting = 13,
                                             .held = 14,
                                             .moved = 15,
                                             .statistics = {.candidates = 17,
                                                            .by_axis = 18,
                                                            .by_filter = 19,
                                                            .by_signs = 20},
                                             .energy_before = 21.5,
                                             .energy_after = 22.5,
                                             .followed = 0.625,
                                             .first_near = 23,
                                             .near = 24,
                                             .near_at_start = 25,
                                         },
                                     .exempt_zones = 26,
                                     .exempt_crossings = 27};

START_TEST(a_summary_tells_all_of_a_response)
{
    write_record(TF_SUMMARY, tf_resolved_fields, &resolved);
    ck_assert_str_eq(
        text, "status: resolved\nfirst contacts: 1\ncontacts: 2\n"
              "impulse rounds: 3\nzone rounds: 4\nrigid rounds: 5\n"
              "failsafe rounds: 6\nrows: 7\nzones: 8\nlargest zone: 9\n"
              "iterations: 10\nviolation: 0.25\nsmallest gap: 0.5\ngroups: 11\n"
              "grouped: 12\nresting: 13\nheld: 14\nmoved: 15\nfollowed: 0.625\n"
              "candidates: 17\ndecided by axis: 18\ndecided by filter: 19\n"
              "decided by signs: 20\nenergy before: 21.5\nenergy after: 22.5\n"
              "seconds: 0.125\nfirst near: 23\nnear: 24\n"
              "near at start: 25\nexempt zones: 26\nexempt crossings: 27\n");
}
END_TEST

START_TEST(json_tells_all_of_a_response)
{
    write_record(TF_JSON, tf_resolved_fields, &resolved);
    ck_assert_str_eq(
        text,
        "{\"status\":\"resolved\",\"first_contacts\":1,\"contacts\":2,"
        "\"impulse_rounds\":3,\"zone_rounds\":4,\"rigid_rounds\":5,"
        "\"failsafe_rounds\":6,\"rows\":7,\"zones\":8,\"largest_zone\":9,"
        "\"iterations\":10,\"violation\":0.25,\"smallest_gap\":0.5,"
        "\"groups\":11,\"grouped\":12,\"resting\":13,\"held\":14,\"moved\":15,"
        "\"followed\":0.625,\"candidates\":17,\"decided_by_axis\":18,"
        "\"decided_by_filter\":19,\"decided_by_signs\":20,"
        "\"energy_before\":21.5,\"energy_after\":22.5,\"seconds\":0.125,"
        "\"first_near\":23,\"near\":24,\"near_at_start\":25,"
        "\"exempt_zones\":26,\"exempt_crossings\":27}\n");
    ck_assert_msg(!json_fault(text), "%s", json_fault(text));
}
END_TEST

// Remeshing -------------------------------------------------------------------

static void write_remeshed(tf_format format)
{
    tf_remeshed remeshed = {
        .triangles_before = 3,
        .triangles_after = 4,
        .edge = 0.5,
        .seconds = 0.125,
    };
    static const tf_error defect[] = {
        {.status = TF_EDGE_NOT_MANIFOLD},   {.status = TF_EDGE_NOT_MANIFOLD},
        {.status = TF_VERTEX_NOT_MANIFOLD}, {.status = TF_COLLINEAR},
        {.status = TF_COLLINEAR},           {.status = TF_COLLINEAR},
        {.status = TF_NOT_EMBEDDED}};
    const tf_defects defects = {
        .count = 7, .defect = defect, .turned = 5, .triangles = 6};
    tf_remeshed_set_defects(&remeshed, &defects);
    remeshed.report = (tf_remesh_report){.rounds = 2,
                                         .least_before = 0.25,
                                         .least_after = 0.375,
                                         .mean_before = 0.75,
                                         .mean_after = 0.875,
                                         .distance = 1.5,
                                         .most_distance = 1.75};
    for (int i = 0; i < TF_OPERATIONS; i++)
        for (int j = 0; j < TF_OUTCOMES; j++)
            remeshed.report.tried[i][j] = (size_t)(100 * (i + 1) + j);
    write_record(format, tf_remeshed_fields, &remeshed);
}

START_TEST(a_summary_tells_all_of_remeshing)
{
    static const char own[] =
        "triangles before: 3\ntriangles: 4\nedge: 0.5\n"
        "least quality before: 0.25\nleast quality: 0.375\n"
        "mean quality before: 0.75\nmean quality: 0.875\ndistance: 1.5\n"
        "distance at most: 1.75\nrounds: 2\nseconds: 0.125\n"
        "turned: 5\nleft alone: 6\nnonmanifold edges: 2\n"
        "nonmanifold vertices: 1\ncollinear triangles: 3\nintersections: 1\n"
        "splits: 101\nimpossible splits: 102\n";
    write_remeshed(TF_SUMMARY);
    ck_assert_int_eq(strncmp(text, own, strlen(own)), 0);
    ck_assert_ptr_nonnull(strstr(text, "\ncollapses past edges: 206\n"));
    ck_assert_ptr_nonnull(strstr(text, "\nmoves past triangles: 407\n"));
}
END_TEST

START_TEST(json_tells_all_of_remeshing)
{
    write_remeshed(TF_JSON);
    ck_assert_ptr_nonnull(strstr(text, "\"least_quality_before\":0.25"));
    ck_assert_ptr_nonnull(strstr(text, "\"overlapping_flips\":304"));
    ck_assert_ptr_nonnull(strstr(text, "}\n"));
}
END_TEST

// Untangling ------------------------------------------------------------------

START_TEST(untangling_is_told_by_its_counts_and_rungs)
{
    static const struct {
        size_t before, left;
        int rungs;
        const char *status, *names;
    } told[] = {
        {0, 0, 0, "clear", "none"},
        {3, 0, TF_RUNG_PUSH | TF_RUNG_RETURN, "untangled", "push return"},
        {3, 2, 63, "tangled", "push smooth again apart relax return"}};
    for (int i = 0; i < 3; i++) {
        tf_untangled_frame done = {
            .before = told[i].before,
            .left = {.count = told[i].left},
            .report = {.rungs = told[i].rungs, .moved = 9}};
        tf_untangled untangled;
        tf_untangled_set(&untangled, &done, 0.25);
        ck_assert_str_eq(untangled.status, told[i].status);
        ck_assert_str_eq(untangled.rung_names, told[i].names);
        ck_assert(untangled.before == told[i].before &&
                  untangled.left == told[i].left && untangled.seconds == 0.25 &&
                  untangled.report.moved == 9);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/reports");
    TCase *reports = tcase_create("reports");
    tcase_add_test(reports, a_summary_tells_all_of_a_response);
    tcase_add_test(reports, json_tells_all_of_a_response);
    tcase_add_test(reports, a_summary_tells_all_of_remeshing);
    tcase_add_test(reports, json_tells_all_of_remeshing);
    tcase_add_test(reports, untangling_is_told_by_its_counts_and_rungs);
    suite_add_tcase(suite, reports);
    return suite;
}
