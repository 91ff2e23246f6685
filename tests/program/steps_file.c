#include "program/steps_file.h"

#include "support/program.h"
#include "support/simulating.h"
#include "support/support.h"

#include <errno.h>
#include <string.h>

#define HEADING                                                                \
    "step,time,first_contacts,contacts,impulse_rounds,zone_rounds,"            \
    "rigid_rounds,failsafe_rounds,rows,held,grouped,resting,stretch,"          \
    "kinetic_energy,elastic_energy,dynamics_seconds,response_seconds\n"

static const tf_step_cost cost = {
    .report = {.first_contacts = 2,
               .contacts = 3,
               .rounds = {4, 5, 6, 7},
               .rows = 8,
               .held = 9,
               .grouped = 10,
               .resting = 11},
    .dynamics = 0.5,
    .response = 0.25,
};

#define LINE(step, time)                                                       \
    step "," time ",2,3,4,5,6,7,8,9,10,11,1.000000,0,0,0.500000,0.250000\n"

/// A chain whose links nothing holds together, and which has no energy.
static tf_simulation *loose_chain(void)
{
    tf_simulation *s = simulation_of(tf_scene_named("plane-chain"), 40);
    s->stage.body.elastics = 0;
    return s;
}

/// A table of three steps of it at rest.
static void make_table(void)
{
    tf_simulation *s = loose_chain();
    FILE *table = tf_steps_file_begin("steps.csv");
    ck_assert_ptr_nonnull(table);
    for (s->step = 1; s->step <= 3; s->step++)
        ck_assert(tf_steps_file_add(table, s, &cost));
    fclose(table);
    tf_simulation_free(s);
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
    tf_simulation *s = loose_chain();
    FILE *table = tf_steps_file_resume("steps.csv", 2);
    ck_assert_ptr_nonnull(table);
    s->step = 3;
    s->velocity[0] = 1;
    ck_assert(tf_steps_file_add(table, s, &cost));
    fclose(table);
    const char *text = file_text("steps.csv");
    expect_words(text, LINE("1", "0.005") LINE("2", "0.01") "3,0.015,2,");
    ck_assert_int_eq(occurrences(text, "\n"), 4);
    tf_simulation_free(s);
}
END_TEST

START_TEST(going_on_from_the_start_leaves_the_heading)
{
    make_table();
    FILE *table = tf_steps_file_resume("steps.csv", 0);
    ck_assert_ptr_nonnull(table);
    fclose(table);
    ck_assert_str_eq(file_text("steps.csv"), HEADING);
}
END_TEST

static void expect_refused(const char *text, int steps)
{
    make_file("bad", text);
    ck_assert_msg(!tf_steps_file_resume("bad", steps), "%s", text);
    ck_assert_int_eq(errno, 0);
    ck_assert_str_eq(file_text("bad"), text);
}

START_TEST(a_line_that_is_missing_is_seen)
{
    expect_refused("", 0);
    expect_refused("step,time\n", 0);
    expect_refused(HEADING, 1);
    expect_refused(HEADING LINE("2", "0.01"), 1);
    expect_refused(HEADING LINE("1", "0.005") "2,0.01,7", 2);
    expect_refused(HEADING LINE("1", "0.005") LINE("12", "0.01"), 2);
}
END_TEST

START_TEST(what_cannot_be_opened)
{
    ck_assert_ptr_null(tf_steps_file_resume("missing", 0));
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_ptr_null(tf_steps_file_begin("missing/steps.csv"));
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_ptr_null(tf_steps_file_begin("/dev/full"));
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
