#define _GNU_SOURCE // usleep

#include "program/progress.h"

#include "support/support.h"
#include "support/terminal.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void replace(int descriptor, const char *path)
{
    int file = open(path, O_WRONLY | O_NOCTTY);
    if (file < 0 || dup2(file, descriptor) < 0)
        _exit(1);
}

/// Work for a while, with these two as standard output and error.
static void work(const char *out, const char *err, double duration)
{
    replace(STDOUT_FILENO, out);
    replace(STDERR_FILENO, err);
    tf_progress_line progress = tf_progress_line_begin(false);
    for (double end = seconds() + duration; seconds() < end; usleep(1000))
        ck_assert(tf_progress_line_show_stage(
            &progress, &(tf_stage){"queries", 1234567, 0}));
    tf_progress_line_end(&progress);
    _exit(0);
}

/// What a terminal shows of work whose output and errors go to these files, or
/// to the terminal where they are NULL.
static const char *shown(const char *out, const char *err, double duration)
{
    terminal screen = terminal_open();
    pid_t worker = fork();
    if (worker == 0)
        work(out ? out : screen.name, err ? err : screen.name, duration);
    int status = 1;
    waitpid(worker, &status, 0);
    ck_assert_int_eq(status, 0);
    return terminal_close(&screen);
}

START_TEST(a_line_is_shown_after_a_second_and_erased)
{
    const char *text = shown("/dev/null", NULL, 2);
    static const char line[] = "\r1,234,567 queries";
    int lines = 0;
    while (strncmp(text, line, strlen(line)) == 0) {
        text += strlen(line);
        lines++;
    }
    ck_assert_str_eq(text, "\r\033[K");
    ck_assert_msg(lines >= 1 && lines <= 6, "%d lines", lines);
}
END_TEST

START_TEST(nothing_is_shown_within_a_second)
{
    ck_assert_str_eq(shown("/dev/null", NULL, 0.1), "");
}
END_TEST

START_TEST(nothing_is_shown_where_answers_go)
{
    ck_assert_str_eq(shown(NULL, NULL, 1.2), "");
}
END_TEST

START_TEST(nothing_is_shown_in_a_log)
{
    ck_assert_str_eq(shown(NULL, "/dev/null", 1.2), "");
    char log[] = "/tmp/tanglefree-log-XXXXXX";
    int file = mkstemp(log);
    shown("/dev/null", log, 1.2);
    ck_assert_int_eq(lseek(file, 0, SEEK_END), 0);
    close(file);
    unlink(log);
}
END_TEST

START_TEST(the_clock_counts_seconds)
{
    double before = tf_clock_seconds();
    usleep(20000);
    double passed = tf_clock_seconds() - before;
    ck_assert_msg(passed >= 0.02 && passed < 20, "%g seconds", passed);
}
END_TEST

START_TEST(the_clock_never_goes_back)
{
    double before = tf_clock_seconds();
    for (int i = 0; i < 10000; i++) {
        double now = tf_clock_seconds();
        ck_assert_double_ge(now, before);
        before = now;
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/progress");
    TCase *line = tcase_create("the line");
    tcase_add_test(line, a_line_is_shown_after_a_second_and_erased);
    tcase_add_test(line, nothing_is_shown_within_a_second);
    tcase_add_test(line, nothing_is_shown_where_answers_go);
    tcase_add_test(line, nothing_is_shown_in_a_log);
    tcase_add_test(line, the_clock_counts_seconds);
    tcase_add_test(line, the_clock_never_goes_back);
    suite_add_tcase(suite, line);
    return suite;
}
