// Arguments of commands, good and refused.
#include "program/command.h"

#include "support/program.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// A message about wrong arguments ends the program with this status.
enum {
    REFUSED = 2,
    DONE = 7
};

static tf_request got;
static bool checked;

static void check(tf_request *request)
{
    checked = true;
    if (request->threads == 13)
        tf_request_refuse(request, "%d threads are bad luck", 13);
}

static int run_it(const tf_request *request)
{
    got = *request;
    return DONE;
}

static const tf_command command = {
    .set = TF_RESOLVE,
    .name = "try",
    .operands = "A [B]",
    .least = 1,
    .most = 2,
    .wanted = "one or two letters are required",
    .description = "Try.\vDone.",
    .check = check,
    .run = run_it,
};

/// Runs the command with words, which are parted by blanks.
static int run_words(const char *words)
{
    static char text[100], name[] = "name";
    static char *arguments[16] = {name};
    int count = 1;
    snprintf(text, sizeof text, "%s", words);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
        arguments[count++] = word;
    arguments[count] = NULL;
    argp_err_exit_status = REFUSED;
    return tf_command_run(&command, count, arguments);
}

START_TEST(operands_and_options_are_passed_on)
{
    ck_assert_int_eq(run_words("-o out a --friction=0.5 b -t 3"), DONE);
    ck_assert(checked);
    ck_assert_int_eq(got.operands, 2);
    ck_assert_str_eq(got.operand[0], "a");
    ck_assert_str_eq(got.operand[1], "b");
    ck_assert_str_eq(got.out, "out");
    ck_assert_double_eq(got.friction, 0.5);
    ck_assert_int_eq(got.threads, 3);
    ck_assert(tf_request_gave(&got, "output"));
    ck_assert(tf_request_gave(&got, "friction"));
    ck_assert(!tf_request_gave(&got, "restitution"));
    run_words("a --output - -- -b");
    ck_assert_int_eq(got.operands, 2);
    ck_assert_str_eq(got.operand[1], "-b");
}
END_TEST

static const struct {
    const char *words, *message;
} refusals[] = {
    {"-o out", "one or two letters are required"},
    {"-o out a b c", "one or two letters are required"},
    {"a", "--output OUT is required: where to write the end of the step, or "
          "the folder for the frames of a scene"},
    {"a -o out -t 13", "13 threads are bad luck"},
    {"a -o out -t 0",
     "--threads must be a whole number from 1 to 256, got '0'"},
    {"a -o out -t 2.5",
     "--threads must be a whole number from 1 to 256, got '2.5'"},
    {"a -o out --restitution 2",
     "--restitution must be a number from 0 to 1, got '2'"},
    {"a -o out --restitution nan",
     "--restitution must be a number from 0 to 1, got 'nan'"},
    {"a -o out --friction=-1",
     "--friction must be a number from 0 on, got '-1'"},
    {"a -o out --friction=1x",
     "--friction must be a number from 0 on, got '1x'"},
    {"a -o out --friction=inf",
     "--friction must be a number from 0 on, got 'inf'"},
    {"a -o out --friction=\x1b",
     "--friction must be a number from 0 on, got '\\x1b'"},
    {"a -o out --solver jacobi",
     "--solver must be gauss-seidel, conjugate-residuals, minres or "
     "normal-residuals, got 'jacobi'"},
    {"a -o out -k edge-edge", "invalid option -- 'k'"},
    {"a --output json",
     "--output json is an old spelling; write --format json, "
     "or ./json for a file of that name"},
    {"a --write out", "--write is an old spelling; write --output"},
    {"a --write=out", "--write is an old spelling; write --output"},
    {"a -o out -m masses", "-m is an old spelling; write --masses"},
    {"a -o out --steps 3", "unrecognized option '--steps'"},
};

START_TEST(wrong_arguments_are_refused)
{
    pid_t child = fork();
    if (child == 0) {
        if (freopen("refusal", "w", stderr))
            run_words(refusals[_i].words);
        exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ck_assert_msg(WIFEXITED(status), "status %#x", (unsigned)status);
    ck_assert_int_eq(WEXITSTATUS(status), REFUSED);
    const char *found = file_text("refusal");
    char right[200];
    snprintf(right, sizeof right, "tanglefree try: %s\n", refusals[_i].message);
    ck_assert_msg(strncmp(found, right, strlen(right)) == 0, "'%s'", found);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/command");
    TCase *arguments = tcase_create("arguments");
    tcase_add_checked_fixture(arguments, enter_folder, leave_folder);
    tcase_add_test(arguments, operands_and_options_are_passed_on);
    tcase_add_loop_test(arguments, wrong_arguments_are_refused, 0,
                        sizeof refusals / sizeof *refusals);
    suite_add_tcase(suite, arguments);
    return suite;
}
