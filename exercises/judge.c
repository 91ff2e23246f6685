// main() of both programs.  With the arguments PROGRAM PRINTED ERRORS it is the
// judge: it executes PROGRAM, the answer's process, confined, with the two files
// as its output, and reports to standard output: what failed, then perhaps a line
// "picture: KIND" and a query that shows the input, then a line "end: HOW", where
// HOW is passed, failed, exit N, signal N, sleeps, memory, closed or free.
#define _GNU_SOURCE // pipe2
#include "judge.h"

#include "check.h"
#include "confine.h"

#include <ctype.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    TICK = 100,    // milliseconds of silence between two looks at the answer
    PATIENCE = 50, // ticks for which it may sleep, all in all
    TEXT = 2000,   // bytes of a text of a failure
    RESULTS = 3,   // the descriptor that results are written to
    NOT_CONFINED = 113 // how the child exits if it must not execute
};

static const long memory = 1L << 31; // bytes that it may use

/// Before each result, and before the texts of a failure.
enum {
    RESULT = 'r',
    FAILURE = 'f'
};

static FILE *results; // of the answer's process; NULL in the judge
static pid_t answer;  // of the judge
static int from_answer;
static char input[TEXT] = "no call yet", picture[TEXT];

// The report ------------------------------------------------------------------

/// A field; lines after the first are indented, and nothing can move the
/// terminal's cursor.
static void show(const char *name, const char *text)
{
    printf("  %-9s ", name);
    for (; *text; text++) {
        putchar(isprint((unsigned char)*text) || *text == '\n' ? *text : '?');
        if (*text == '\n')
            printf("%12s", "");
    }
    putchar('\n');
}

static _Noreturn void end(const char *how, ...)
{
    if (*picture)
        printf("picture: %s\n", picture);
    va_list arguments;
    va_start(arguments, how);
    printf("end: ");
    vprintf(how, arguments);
    putchar('\n');
    va_end(arguments);
    kill(answer, SIGKILL);
    exit(EXIT_SUCCESS);
}

static _Noreturn void report_failure(const char *expected, const char *got,
                                     const char *where)
{
    show("input", input);
    show("expected", expected);
    show("got", got);
    show("where", where);
    end("failed");
}

static _Noreturn void report_end(int status)
{
    show("input", input);
    if (WIFSIGNALED(status))
        end("signal %d", WTERMSIG(status));
    end(WEXITSTATUS(status) == NOT_CONFINED ? "free" : "exit %d",
        WEXITSTATUS(status));
}

// The judge's side ------------------------------------------------------------

/// Field number `n` of /proc/PID/stat, counted from 1, n > 2.
static bool read_state(int n, char field[32])
{
    char path[64], line[1024] = "";
    snprintf(path, sizeof path, "/proc/%d/stat", (int)answer);
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    size_t length = fread(line, 1, sizeof line - 1, file);
    fclose(file);
    line[length] = '\0';

    // The second field, a name in parentheses, may contain spaces.
    char *at = strrchr(line, ')'), *word = at ? strtok(at + 1, " ") : NULL;
    for (int i = 3; word && i < n; i++)
        word = strtok(NULL, " ");
    return word && snprintf(field, 32, "%s", word) > 0;
}

/// Whether the answer has been found asleep too often.  One that computes, or
/// that waits for a processor, is awake.
static bool is_asleep(void)
{
    static int slept;
    char field[32];
    return read_state(3, field) && (*field == 'S' || *field == 'T') &&
           ++slept > PATIENCE;
}

/// The answer is silent: it may compute until the kernel ends it, but neither
/// wait nor take all memory.
static void look_at_answer(void)
{
    char field[32];
    const char *how = NULL;
    if (is_asleep())
        how = "sleeps";
    if (read_state(24, field) && atol(field) > memory / sysconf(_SC_PAGESIZE))
        how = "memory";
    if (how) {
        show("input", input);
        end("%s", how);
    }
}

/// Nothing will come any more: report how the answer ended.
static _Noreturn void await_end(void)
{
    int status;
    while (waitpid(answer, &status, WNOHANG) != answer) {
        if (is_asleep()) {
            show("input", input);
            end("closed");
        }
        poll(NULL, 0, TICK);
    }
    report_end(status);
}

static long now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (long)time.tv_sec * 1000 + time.tv_nsec / 1000000;
}

/// Also an answer that sends a byte now and then is silent in between.
static void await_data(void)
{
    static long silent;
    struct pollfd ready = {.fd = from_answer, .events = POLLIN};
    for (int some = 0; some == 0;) {
        long before = now();
        some = poll(&ready, 1, TICK);
        silent += now() - before;
        if (silent >= TICK)
            look_at_answer();
        silent %= TICK;
    }
}

static size_t receive_some(char *to, size_t size)
{
    await_data();
    ssize_t got = read(from_answer, to, size);
    return got > 0 ? (size_t)got : 0;
}

static void receive(void *to, size_t size)
{
    for (size_t done = 0; done < size;) {
        size_t more = receive_some((char *)to + done, size - done);
        if (more == 0)
            await_end();
        done += more;
    }
}

static void receive_text(char text[TEXT])
{
    int length = 0;
    char next;
    do {
        receive(&next, 1);
        text[length] = next;
        length += length < TEXT - 1;
    } while (next);
    text[length] = '\0';
}

static void receive_result(void *result, size_t size)
{
    char kind, expected[TEXT], got[TEXT], where[TEXT];
    receive(&kind, 1);
    if (kind == FAILURE) {
        receive_text(expected);
        receive_text(got);
        receive_text(where);
        report_failure(expected, got, where);
    }
    receive(result, size);
}

/// In the child: execute the program with nothing open but its results and the
/// files that it prints to.
static _Noreturn void become_answer(int to_judge, char *const files[])
{
    const int write_only = O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC;
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
    dup2(open(files[1], write_only, 0666), STDOUT_FILENO);
    dup2(open(files[2], write_only, 0666), STDERR_FILENO);
    if (to_judge == RESULTS)
        fcntl(to_judge, F_SETFD, 0);
    else
        dup2(to_judge, RESULTS);
    if (confine())
        execl(files[0], files[0], (char *)NULL);
    _exit(NOT_CONFINED);
}

static void start_answer(char *const files[])
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0 || (answer = fork()) < 0) {
        perror("the judge cannot start the answer");
        exit(EXIT_FAILURE);
    }
    if (answer == 0)
        become_answer(ends[1], files);
    close(ends[1]);
    from_answer = ends[0];
}

// Both sides ------------------------------------------------------------------

void judge_note_input(const char *text)
{
    snprintf(input, sizeof input, "%s", text);
    *picture = '\0';
}

void judge_note_picture(const char *text)
{
    snprintf(picture, sizeof picture, "%s", text);
}

void judge_fail(const char *expected, const char *got, const char *where)
{
    if (!results)
        report_failure(expected, got, where);
    fflush(stdout);
    fprintf(results, "%c%s%c%s%c%s%c", FAILURE, expected, '\0', got, '\0',
            where, '\0');
    fflush(results);
    _exit(EXIT_SUCCESS);
}

bool check_makes_calls(void)
{
    return results != NULL;
}

void check_take(void *result, size_t size)
{
    if (!results) {
        receive_result(result, size);
        return;
    }
    fputc(RESULT, results);
    fwrite(result, 1, size, results);
    fflush(results);
}

int main(int count, char *arguments[])
{
    if (count == 4) {
        start_answer(arguments + 1);
        run_tests();
        end("passed");
    }
    results = fdopen(RESULTS, "w");
    if (!results) {
        fprintf(stderr, "usage: %s PROGRAM PRINTED ERRORS\n", arguments[0]);
        return EXIT_FAILURE;
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    run_tests();
    return EXIT_SUCCESS;
}
