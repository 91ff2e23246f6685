#include "program/arguments.h"

#include "support/program.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// A message about wrong arguments ends the program with this status.
enum {
    REFUSED = 2
};

static double number;
static int threads;

static error_t parse(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case 'n':
        number = tf_parse_number(state, "number", text, 8, "0 to 8");
        return 0;
    case 't':
        threads = tf_parse_threads(state, text);
        return 0;
    case 'r':
        tf_refuse_name(state, "color", text, "red or blue");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void parse_option(const char *option, const char *text)
{
    static const struct argp_option options[] = {
        {"number", 'n', "X", 0, NULL, 0},
        {"threads", 't', "X", 0, NULL, 0},
        {"refuse", 'r', "X", 0, NULL, 0},
        {0}};
    static const struct argp parser = {.options = options, .parser = parse};
    char name[] = "name", given[3], argument[100];
    char *arguments[] = {name, given, argument, NULL};
    snprintf(given, sizeof given, "%s", option);
    snprintf(argument, sizeof argument, "%s", text);
    argp_err_exit_status = REFUSED;
    argp_parse(&parser, 3, arguments, 0, NULL, NULL);
}

static const struct {
    const char *option, *text, *message;
} refusals[] = {
    {"-n", "-1", "name: --number needs a number, 0 to 8, and not '-1'\n"},
    {"-n", "8.1", "name: --number needs a number, 0 to 8, and not '8.1'\n"},
    {"-n", "nan", "name: --number needs a number, 0 to 8, and not 'nan'\n"},
    {"-n", "inf", "name: --number needs a number, 0 to 8, and not 'inf'\n"},
    {"-n", "1x", "name: --number needs a number, 0 to 8, and not '1x'\n"},
    {"-n", "\x1b", "name: --number needs a number, 0 to 8, and not '\\x1b'\n"},
    {"-t", "0", "name: '0' is not a number of threads; choose 1 to 256\n"},
    {"-t", "257", "name: '257' is not a number of threads; choose 1 to 256\n"},
    {"-t", "2x", "name: '2x' is not a number of threads; choose 1 to 256\n"},
    {"-r", "green", "name: unknown color 'green'; choose red or blue\n"},
};

START_TEST(good_arguments)
{
    parse_option("-n", "0");
    ck_assert_double_eq(number, 0);
    parse_option("-n", "0x1p3");
    ck_assert_double_eq(number, 8);
    parse_option("-n", "2.5e-1");
    ck_assert_double_eq(number, 0.25);
    parse_option("-t", "1");
    ck_assert_int_eq(threads, 1);
    parse_option("-t", "256");
    ck_assert_int_eq(threads, 256);
}
END_TEST

START_TEST(refused_arguments)
{
    pid_t child = fork();
    if (child == 0) {
        if (freopen("refusal", "w", stderr))
            parse_option(refusals[_i].option, refusals[_i].text);
        exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ck_assert_msg(WIFEXITED(status), "status %#x", (unsigned)status);
    ck_assert_int_eq(WEXITSTATUS(status), REFUSED);
    const char *found = file_text("refusal"), *wanted = refusals[_i].message;
    ck_assert_msg(strncmp(found, wanted, strlen(wanted)) == 0, "'%s'", found);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/arguments");
    TCase *arguments = tcase_create("arguments");
    tcase_add_checked_fixture(arguments, enter_folder, leave_folder);
    tcase_add_test(arguments, good_arguments);
    tcase_add_loop_test(arguments, refused_arguments, 0,
                        sizeof refusals / sizeof *refusals);
    suite_add_tcase(suite, arguments);
    return suite;
}
