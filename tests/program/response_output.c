#define _GNU_SOURCE // open_memstream

#include "program/response_output.h"

#include "support/json.h"
#include "support/support.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/// Every number is another one.
static const tf_response_report report = {
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
};

static char *text;

static void write_report(const tf_response_report *of, tf_format format)
{
    size_t size;
    free(text);
    FILE *stream = open_memstream(&text, &size);
    ck_assert(tf_response_output_write(stream, format, of, 0.125));
    fclose(stream);
}

START_TEST(a_summary_has_a_line_for_each_number)
{
    write_report(&report, TF_SUMMARY);
    ck_assert_str_eq(
        text, "status: resolved\nfirst contacts: 1\ncontacts: 2\n"
              "impulse rounds: 3\nzone rounds: 4\nrigid rounds: 5\n"
              "failsafe rounds: 6\nrows: 7\nzones: 8\nlargest zone: 9\n"
              "iterations: 10\nviolation: 0.25\nsmallest gap: 0.5\ngroups: 11\n"
              "grouped: 12\nresting: 13\nheld: 14\nmoved: 15\n"
              "candidates: 17\ndecided by axis: 18\ndecided by filter: 19\n"
              "decided by signs: 20\nenergy before: 21.5\nenergy after: 22.5\n"
              "seconds: 0.125\n");
}
END_TEST

START_TEST(json_has_a_member_for_each_number)
{
    write_report(&report, TF_JSON);
    ck_assert_str_eq(
        text,
        "{\"status\":\"resolved\",\"first_contacts\":1,\"contacts\":2,"
        "\"impulse_rounds\":3,\"zone_rounds\":4,\"rigid_rounds\":5,"
        "\"failsafe_rounds\":6,\"rows\":7,\"zones\":8,\"largest_zone\":9,"
        "\"iterations\":10,\"violation\":0.25,\"smallest_gap\":0.5,"
        "\"groups\":11,\"grouped\":12,\"resting\":13,\"held\":14,\"moved\":15,"
        "\"candidates\":17,\"decided_by_axis\":18,"
        "\"decided_by_filter\":19,\"decided_by_signs\":20,"
        "\"energy_before\":21.5,\"energy_after\":22.5,\"seconds\":0.125}\n");
    ck_assert_msg(!json_fault(text), "%s", json_fault(text));
}
END_TEST

START_TEST(a_step_without_contacts_was_clear)
{
    tf_response_report clear = {.energy_before = 1, .energy_after = 1};
    write_report(&clear, TF_JSON);
    ck_assert_int_eq(strncmp(text, "{\"status\":\"clear\",", 18), 0);
    write_report(&clear, TF_SUMMARY);
    ck_assert_int_eq(strncmp(text, "status: clear\n", 14), 0);
}
END_TEST

START_TEST(a_full_disk_is_noticed)
{
    FILE *stream = fopen("/dev/full", "w");
    ck_assert(!tf_response_output_write(stream, TF_JSON, &report, 1));
    ck_assert_int_eq(errno, ENOSPC);
    fclose(stream);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/response_output");
    TCase *reports = tcase_create("reports");
    tcase_add_test(reports, a_summary_has_a_line_for_each_number);
    tcase_add_test(reports, json_has_a_member_for_each_number);
    tcase_add_test(reports, a_step_without_contacts_was_clear);
    tcase_add_test(reports, a_full_disk_is_noticed);
    suite_add_tcase(suite, reports);
    return suite;
}
