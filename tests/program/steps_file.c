#include "program/steps_file.h"

#include "support/program.h"
#include "support/support.h"

#include <errno.h>

#define HEADING "step,time,things,others\n"

/// A line tells twice how long a step is.
static void write_line(FILE *table, const tf_simulated *of)
{
    fprintf(table, ",%g,x", of->length);
}

static const tf_simulated_kind kind = {.columns = "things,others",
                                       .write_line = write_line};

#define LINE(step, time) step "," time ",0.005,x\n"

/// A table of three steps.
static void make_table(void)
{
    tf_simulated s = {.kind = &kind, .length = 0.005};
    FILE *table = tf_steps_file_begin("steps.csv", &kind);
    ck_assert_ptr_nonnull(table);
    for (s.step = 1; s.step <= 3; s.step++)
        ck_assert(tf_steps_file_add(table, &s));
    fclose(table);
}

START_TEST(a_table_has_a_line_a_step)
{
    make_table();
    ck_assert_str_eq(file_text("steps.csv"),
                     HEADING LINE("1", "0.005") LINE("2", "0.01")
                         LINE("3", "0.015"));
}
END_TEST

START_TEST(going_on_removes_later_lines)
{
    make_table();
    tf_simulated s = {.kind = &kind, .length = 0.0025, .step = 3};
    FILE *table = tf_steps_file_resume("steps.csv", &kind, 2);
    ck_assert_ptr_nonnull(table);
    ck_assert(tf_steps_file_add(table, &s));
    fclose(table);
    ck_assert_str_eq(file_text("steps.csv"),
                     HEADING LINE("1", "0.005")
                         LINE("2", "0.01") "3,0.0075,0.0025,x\n");
}
END_TEST

START_TEST(going_on_from_the_start_leaves_the_heading)
{
    make_table();
    FILE *table = tf_steps_file_resume("steps.csv", &kind, 0);
    ck_assert_ptr_nonnull(table);
    fclose(table);
    ck_assert_str_eq(file_text("steps.csv"), HEADING);
}
END_TEST

static void expect_refused(const char *text, int steps)
{
    make_file("bad", text);
    ck_assert_msg(!tf_steps_file_resume("bad", &kind, steps), "%s", text);
    ck_assert_int_eq(errno, 0);
    ck_assert_str_eq(file_text("bad"), text);
}

START_TEST(a_line_that_is_missing_is_seen)
{
    expect_refused("", 0);
    expect_refused("step,time\n", 0);
    expect_refused("step,time,things,other\n", 0);
    expect_refused(HEADING, 1);
    expect_refused(HEADING LINE("2", "0.01"), 1);
    expect_refused(HEADING LINE("1", "0.005") "2,0.01,7", 2);
    expect_refused(HEADING LINE("1", "0.005") LINE("12", "0.01"), 2);
}
END_TEST

START_TEST(what_cannot_be_opened)
{
    ck_assert_ptr_null(tf_steps_file_resume("missing", &kind, 0));
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_ptr_null(tf_steps_file_begin("missing/steps.csv", &kind));
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_ptr_null(tf_steps_file_begin("/dev/full", &kind));
    ck_assert_int_eq(errno, ENOSPC);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/steps_file");
    TCase *tcase = tcase_create("tables");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_table_has_a_line_a_step);
    tcase_add_test(tcase, going_on_removes_later_lines);
    tcase_add_test(tcase, going_on_from_the_start_leaves_the_heading);
    tcase_add_test(tcase, a_line_that_is_missing_is_seen);
    tcase_add_test(tcase, what_cannot_be_opened);
    suite_add_tcase(suite, tcase);
    return suite;
}
