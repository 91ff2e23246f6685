#include "program/steps_file.h"

#include "simulate/cloth_simulation.h"
#include "support/program.h"
#include "support/support.h"

#include <errno.h>

#define HEADING                                                                \
    "step,time,first_contacts,contacts,impulse_rounds,zone_rounds,"            \
    "rigid_rounds,failsafe_rounds,rows,held,grouped,resting,stretch,"          \
    "kinetic_energy,elastic_energy,dynamics_seconds,response_seconds\n"

/// Two contacts, and nothing else.
#define LINE(step, time)                                                       \
    step "," time ",0,2,0,0,0,0,0,0,0,0,0.000000,0,0,0.000000,0.000000\n"

static const tf_scene scene = {.kind = &tf_cloth_kind, .step = 0.005};

static bool add_line(FILE *table, int step)
{
    tf_cloth_simulation cloth = {.base = {.scene = &scene}};
    cloth.report.response.contacts = 2;
    tf_simulation_go_to(&cloth.base, step);
    return tf_steps_file_add(table, &cloth.base);
}

/// A table of three steps.
static void make_table(void)
{
    FILE *table = tf_steps_file_begin("steps.csv", &tf_cloth_kind);
    ck_assert_ptr_nonnull(table);
    for (int step = 1; step <= 3; step++)
        ck_assert(add_line(table, step));
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
    FILE *table = tf_steps_file_resume("steps.csv", &tf_cloth_kind, 2);
    ck_assert_ptr_nonnull(table);
    ck_assert(add_line(table, 7));
    fclose(table);
    ck_assert_str_eq(file_text("steps.csv"),
                     HEADING LINE("1", "0.005") LINE("2", "0.01")
                         LINE("7", "0.035"));
}
END_TEST

START_TEST(going_on_from_the_start_leaves_the_heading)
{
    make_table();
    FILE *table = tf_steps_file_resume("steps.csv", &tf_cloth_kind, 0);
    ck_assert_ptr_nonnull(table);
    fclose(table);
    ck_assert_str_eq(file_text("steps.csv"), HEADING);
}
END_TEST

static void expect_refused(const char *text, int steps)
{
    make_file("bad", text);
    ck_assert_msg(!tf_steps_file_resume("bad", &tf_cloth_kind, steps), "%s",
                  text);
    ck_assert_int_eq(errno, 0);
    ck_assert_str_eq(file_text("bad"), text);
}

START_TEST(a_line_that_is_missing_is_seen)
{
    expect_refused("", 0);
    expect_refused("step,time\n", 0);
    expect_refused("step,time,contacts,first_contacts\n", 0);
    expect_refused("step,time,first_contacts,contacts,", 0);
    expect_refused(HEADING, 1);
    expect_refused(HEADING LINE("2", "0.01"), 1);
    expect_refused(HEADING LINE("1", "0.005") "2,0.01,7", 2);
    expect_refused(HEADING LINE("1", "0.005") LINE("12", "0.01"), 2);
}
END_TEST

START_TEST(errno_tells_why_a_table_cannot_be_opened)
{
    ck_assert_ptr_null(tf_steps_file_resume("missing", &tf_cloth_kind, 0));
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_ptr_null(
        tf_steps_file_begin("missing/steps.csv", &tf_cloth_kind));
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_ptr_null(tf_steps_file_begin("/dev/full", &tf_cloth_kind));
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
    tcase_add_test(tcase, errno_tells_why_a_table_cannot_be_opened);
    suite_add_tcase(suite, tcase);
    return suite;
}
