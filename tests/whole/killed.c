// What is left of programs that are killed, and what the next ones leave.

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>

/// The scratch files here and in the folder made.
#define SCRATCHES                                                              \
    "ls -A . made 2>/dev/null | grep -E '^\\.tanglefree-[0-9a-f]{8}(\\.|$)'"

/// Kills a program at a time when it has a scratch file, at which it is stopped
/// before.
static void kill_writing(const char *command)
{
    outcome found =
        run("%s >/dev/null 2>&1 & while kill -STOP $! || exit 9; "
            "until grep -q 'State:.[TZ]' /proc/$!/status; do :; done; "
            "! " SCRATCHES " >/dev/null; do kill -CONT $!; sleep 0.005; done; "
            "kill -KILL $!; wait $!",
            command);
    ck_assert_msg(found.status == 137, "%s: status %d, %s", command,
                  found.status, found.err);
    ck_assert_int_eq(occurrences(run(SCRATCHES).out, "\n"), 1);
}

static void expect_none_left(const char *command)
{
    outcome found = run("%s", command);
    ck_assert_msg(found.status == 0, "%s: %s", command, found.err);
    expect(run(SCRATCHES), 1, "", "");
}

/// What might be taken for a scratch file.
static void make_files_of_the_user(void)
{
    make_file(".tanglefree-notes.ply", "notes");
    make_file(".tanglefree-config.obj", "config");
    make_file(".tanglefree-", "more");
}

static void expect_files_of_the_user(void)
{
    expect(run("cat .tanglefree-*"), 0, "moreconfignotes", "");
}

#define SIMULATION "$tf simulate plane-chain --size 40 -o made --steps "

START_TEST(a_simulation_that_goes_on)
{
    expect_none_left(SIMULATION "0");
    kill_writing(SIMULATION "99999 --resume");
    make_files_of_the_user();
    expect(run("mv .tanglefree-* made"), 0, "", "");
    expect_none_left(SIMULATION "$(ls made | grep -c frame) --resume");
    kill_writing(SIMULATION "99999 --resume");
    expect_none_left(SIMULATION "0 --resume");
    expect(run("mv made/.tanglefree-* ."), 0, "", "");
    expect_files_of_the_user();
}
END_TEST

enum {
    TEETH = 400 // of a comb, as many as take a second
};

/// Two combs in the plane, of which one is moved through the other.
static void make_combs(const char *name, double x)
{
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    for (int i = 0; i < TEETH; i++)
        fprintf(file, "v %d 0\nv %d %d\n", i, i, TEETH - 1);
    for (int i = 0; i < TEETH; i++)
        fprintf(file, "v %g %d.5\nv %g %d.5\n", x - 0.5, i, x + TEETH - 0.75,
                i);
    for (int i = 0; i < 2 * TEETH; i++)
        fprintf(file, "l %d %d\n", 2 * i + 1, 2 * i + 2);
    fclose(file);
}

START_TEST(a_step_that_is_resolved)
{
    make_combs("start", -TEETH - 0.25);
    make_combs("end", 0);
    kill_writing("$tf resolve start end -o new.obj -t 1");
    make_files_of_the_user();
    expect_none_left("$tf resolve start start -o new.obj -t 1");
    expect(run("ls new.obj"), 0, "new.obj\n", "");
    expect_files_of_the_user();
}
END_TEST

START_TEST(a_mesh_that_is_remeshed)
{
    make_file("square", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n"
                        "f 1 3 4\n");
    make_file("new.ply", "old");
    kill_writing("$tf remesh square -o new.ply -e 0.003");
    ck_assert_str_eq(file_text("new.ply"), "old");
    make_files_of_the_user();
    expect_none_left("$tf remesh square -o ./new.ply -e 9");
    expect_words(file_text("new.ply"), "ply\n");
    expect_files_of_the_user();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/killed");
    TCase *tcase = tcase_create("commands");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_simulation_that_goes_on);
    tcase_add_test(tcase, a_step_that_is_resolved);
    tcase_add_test(tcase, a_mesh_that_is_remeshed);
    suite_add_tcase(suite, tcase);
    return suite;
}
