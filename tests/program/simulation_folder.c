#include "program/simulation_folder.h"

#include "support/program.h"
#include "support/simulations.h"
#include "support/support.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static tf_simulation *chain(void)
{
    return &cloth_of("plane-chain", 40)->base;
}

static void advance(tf_simulation *s)
{
    ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}), TF_OK);
}

/// What is printed of the fault of a folder.
static const char *fault_of(const tf_simulation_folder *folder)
{
    static char text[TF_PATH_ROOM + TF_FAULT_ROOM + 3];
    snprintf(text, sizeof text, "%s: %s", folder->fault.file,
             folder->fault.text);
    return text;
}

/// Makes the folder "made" of some steps.
static void make_steps(int steps)
{
    tf_simulation *s = chain();
    tf_simulation_folder folder;
    ck_assert_msg(tf_simulation_folder_begin(&folder, "made", s), "%s",
                  fault_of(&folder));
    while (s->step < steps) {
        advance(s);
        ck_assert(tf_simulation_folder_add(&folder, s));
    }
    tf_simulation_folder_close(&folder);
    tf_simulation_free(s);
}

/// The step to which the folder "made" brings a simulation; -1, if it refuses
/// with these words.
static int resumed(const char *words)
{
    tf_simulation *s = chain();
    tf_simulation_folder folder;
    bool good = tf_simulation_folder_resume(&folder, "made", s);
    int step = good ? s->step : -1;
    if (!good)
        expect_words(fault_of(&folder), words);
    tf_simulation_folder_close(&folder);
    tf_simulation_free(s);
    return step;
}

START_TEST(a_folder_has_a_frame_and_a_line_a_step)
{
    make_steps(3);
    outcome found = run("ls -A made; wc -l <made/steps.csv");
    expect(found, 0,
           "frame-00000.ply\nframe-00001.ply\nframe-00002.ply\n"
           "frame-00003.ply\nsteps.csv\n4\n",
           "");
    ck_assert_int_eq(resumed(""), 3);
}
END_TEST

START_TEST(only_an_empty_folder_is_taken)
{
    tf_simulation *s = chain();
    tf_simulation_folder folder;
    ck_assert_int_eq(mkdir("made", 0777), 0);
    make_steps(0);
    ck_assert(!tf_simulation_folder_begin(&folder, "made", s));
    ck_assert_str_eq(
        fault_of(&folder),
        "made: exists, and is not an empty folder; choose another, "
        "or go on with the simulation in it by --resume");
    make_file("file", "");
    ck_assert(!tf_simulation_folder_begin(&folder, "file", s));
    expect_words(fault_of(&folder), "file: exists, and is not an empty folder");
    ck_assert(!tf_simulation_folder_begin(&folder, "missing/folder", s));
    ck_assert_str_eq(
        fault_of(&folder),
        "missing/folder: there is no folder 'missing'; make it, or "
        "choose another");
    tf_simulation_free(s);
}
END_TEST

START_TEST(the_last_frame_is_the_state)
{
    make_steps(12);
    unlink("made/frame-00012.ply");
    make_file("made/frame-99.ply", "foreign");
    make_file("made/frame-00099.obj", "foreign");
    ck_assert_int_eq(resumed(""), 11);
    ck_assert_int_eq(occurrences(file_text("made/steps.csv"), "\n"), 12);
}
END_TEST

START_TEST(missing_and_foreign_files_cannot_be_resumed)
{
    ck_assert_int_eq(
        resumed("made: has no frames to go on from; leave out --resume"), -1);
    make_steps(3);
    make_file("made/frame-00004.ply", "foreign");
    ck_assert_int_eq(resumed("made/frame-00004.ply: is no frame of 'tanglefree "
                             "simulate plane-chain --size 40'; correct"),
                     -1);
    ck_assert_int_eq(rename("made/frame-00003.ply", "made/frame-00004.ply"), 0);
    ck_assert_int_eq(resumed("made/frame-00004.ply: is no frame of"), -1);
    unlink("made/frame-00004.ply");
    ck_assert_int_eq(resumed(""), 2);
    make_file("made/steps.csv", "");
    ck_assert_int_eq(
        resumed("made/steps.csv: has no line for each of the 2 steps"), -1);
    unlink("made/steps.csv");
    ck_assert_int_eq(resumed("made/steps.csv: cannot open: No such file"), -1);
}
END_TEST

START_TEST(a_frame_that_cannot_be_written_leaves_nothing)
{
    tf_simulation *s = chain();
    tf_simulation_folder folder;
    ck_assert(tf_simulation_folder_begin(&folder, "made", s));
    ck_assert_int_eq(mkdir("made/frame-00001.ply", 0777), 0);
    advance(s);
    ck_assert(!tf_simulation_folder_add(&folder, s));
    ck_assert_str_eq(fault_of(&folder),
                     "made/frame-00001.ply: cannot write: Is a directory; mend "
                     "that, and go on with --resume");
    tf_simulation_folder_close(&folder);
    tf_simulation_free(s);
    expect(run("ls -A made"), 0,
           "frame-00000.ply\nframe-00001.ply\nsteps.csv\n", "");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/simulation_folder");
    TCase *tcase = tcase_create("folders");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_folder_has_a_frame_and_a_line_a_step);
    tcase_add_test(tcase, only_an_empty_folder_is_taken);
    tcase_add_test(tcase, the_last_frame_is_the_state);
    tcase_add_test(tcase, missing_and_foreign_files_cannot_be_resumed);
    tcase_add_test(tcase, a_frame_that_cannot_be_written_leaves_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
