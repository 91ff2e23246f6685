#define _POSIX_C_SOURCE 200809L // fork, pipe

#include "base/contract.h"

#include "base/require.h"
#include "support/support.h"

#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

START_TEST(a_kept_contract_calls_no_handler)
{
    TF_REQUIRE(1 + 1 == 2);
}
END_TEST

static void exit_with_line(const char *file, int line, const char *condition)
{
    bool told = strstr(file, "contract.c") && strcmp(condition, "1 > 2") == 0;
    exit(told && line > 0 ? 7 : 1);
}

START_TEST(the_handler_is_told_file_line_and_condition)
{
    tf_contract_set_handler(exit_with_line);
    TF_REQUIRE(1 > 2);
}
END_TEST

static void return_quietly(const char *file, int line, const char *condition)
{
    (void)file, (void)line, (void)condition;
}

START_TEST(the_program_aborts_if_the_handler_returns)
{
    tf_contract_set_handler(return_quietly);
    TF_REQUIRE(1 > 2);
}
END_TEST

START_TEST(null_restores_the_default_handler)
{
    tf_contract_handler *initial = tf_contract_set_handler(return_quietly);
    ck_assert(tf_contract_set_handler(NULL) == return_quietly);
    ck_assert(tf_contract_set_handler(NULL) == initial);
}
END_TEST

START_TEST(the_default_handler_prints_file_line_and_condition)
{
    int end[2];
    ck_assert_int_eq(pipe(end), 0);
    pid_t child = fork();
    if (child == 0) {
        // Where a signal ends a program, an emulator prints a line of its own.
        signal(SIGABRT, _exit);
        dup2(end[1], STDERR_FILENO);
        tf_contract_broken("some.c", 42, "1 > 2");
    }
    close(end[1]);
    char text[200] = "";
    ck_assert_int_gt(read(end[0], text, sizeof text - 1), 0);
    close(end[0]);
    ck_assert_str_eq(text, "some.c:42: broken contract: 1 > 2\n");
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status) && WEXITSTATUS(status) == SIGABRT);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/contract");
    TCase *tcase = tcase_create("contract");
    tcase_add_test(tcase, a_kept_contract_calls_no_handler);
    tcase_add_exit_test(tcase, the_handler_is_told_file_line_and_condition, 7);
    tcase_add_test_raise_signal(
        tcase, the_program_aborts_if_the_handler_returns, SIGABRT);
    tcase_add_test(tcase, null_restores_the_default_handler);
    tcase_add_test(tcase, the_default_handler_prints_file_line_and_condition);
    suite_add_tcase(suite, tcase);
    return suite;
}
