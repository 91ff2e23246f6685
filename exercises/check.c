#define _XOPEN_SOURCE 700 // setrlimit
#include "check.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum {
    TEXT = 2000,
    TEXTS = 16,
    SECONDS = 5 // of the processor, whatever else the machine does
};

static const char *told; // where to tell
static char input[TEXT] = "no call yet";

/// Tell under a name; lines after the first are indented.
static void tell(FILE *out, const char *name, const char *text)
{
    fprintf(out, "  %-9s ", name);
    for (; *text; text++) {
        fputc(*text, out);
        if (*text == '\n')
            fprintf(out, "%12s", "");
    }
    fputc('\n', out);
}

static FILE *open_told(void)
{
    FILE *out = fopen(told, "w");
    if (!out) {
        perror(told);
        exit(EXIT_FAILURE);
    }
    return out;
}

void check_input(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(input, sizeof input, format, arguments);
    va_end(arguments);

    // Told at once: if the call crashes it is all that is known.
    FILE *out = open_told();
    tell(out, "input", input);
    fclose(out);
}

void check_at(const char *file, int line, bool good, const char *expected,
              const char *got, ...)
{
    if (good)
        return;
    char text[TEXT];
    va_list arguments;
    va_start(arguments, got);
    vsnprintf(text, sizeof text, got, arguments);
    va_end(arguments);

    FILE *out = open_told();
    tell(out, "input", input);
    tell(out, "expected", expected);
    tell(out, "got", text);
    snprintf(text, sizeof text, "%s:%d", file, line);
    tell(out, "where", text);
    fclose(out);
    exit(EXIT_FAILURE);
}

void check_near_at(const char *file, int line, double expected, double got,
                   double tolerance)
{
    bool good = expected == got || fabs(expected - got) <= tolerance;
    check_at(file, line, good, text_real(expected), "%s", text_real(got));
}

void check_point_at(const char *file, int line, int n, const double expected[],
                    const double got[], double tolerance)
{
    bool good = true;
    for (int k = 0; k < n; k++)
        good &= fabs(expected[k] - got[k]) <= tolerance;
    check_at(file, line, good, text_point(n, expected), "%s",
             text_point(n, got));
}

void check_finite_at(const char *file, int line, int axes, int count,
                     const tf_worldline lines[])
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < axes; k++)
            check_at(file, line,
                     isfinite(lines[i].at[0].x[k]) &&
                         isfinite(lines[i].at[1].x[k]),
                     "finite coordinates", "%s", text_line(axes, &lines[i]));
}

static char *next_text(void)
{
    static char texts[TEXTS][TEXT];
    static int next;
    next = (next + 1) % TEXTS;
    texts[next][0] = '\0';
    return texts[next];
}

static void append(char *text, const char *more)
{
    strncat(text, more, TEXT - strlen(text) - 1);
}

static void append_real(char *text, double x)
{
    char digits[32];
    for (int places = 6; places <= 17; places++) {
        snprintf(digits, sizeof digits, "%.*g", places, x);
        if (strtod(digits, NULL) == x)
            break;
    }
    append(text, digits);
}

static void append_point(char *text, int n, const double x[])
{
    for (int k = 0; k < n; k++) {
        append(text, k == 0 ? "(" : ", ");
        append_real(text, x[k]);
    }
    append(text, ")");
}

static void append_line(char *text, int axes, const tf_worldline *line)
{
    append_point(text, axes, line->at[0].x);
    append(text, " -> ");
    append_point(text, axes, line->at[1].x);
}

const char *text_real(double x)
{
    char *text = next_text();
    append_real(text, x);
    return text;
}

const char *text_point(int n, const double x[])
{
    char *text = next_text();
    append_point(text, n, x);
    return text;
}

const char *text_line(int axes, const tf_worldline *line)
{
    char *text = next_text();
    append_line(text, axes, line);
    return text;
}

const char *text_lines(int axes, const char *name, int count,
                       const tf_worldline lines[])
{
    char *text = next_text();
    for (int i = 0; i < count; i++) {
        char label[32];
        snprintf(label, sizeof label, "%s%s %d: ", i == 0 ? "" : "\n", name, i);
        append(text, label);
        append_line(text, axes, &lines[i]);
    }
    return text;
}

const char *text_sign(int sign)
{
    static const char *const words[] = {"negative", "zero", "positive",
                                        "unknown"};
    return sign >= -1 && sign <= 2 ? words[sign + 1] : "no sign at all";
}

int main(int count, char *arguments[])
{
    if (count != 2) {
        fprintf(stderr, "usage: %s FILE-TO-REPORT-TO\n", arguments[0]);
        return EXIT_FAILURE;
    }
    told = arguments[1];
    setrlimit(RLIMIT_CPU, &(struct rlimit){SECONDS, SECONDS + 1});
    TCase *tests = tcase_create("checks");
    add_tests(tests);
    Suite *suite = suite_create("exercise");
    suite_add_tcase(suite, tests);

    // In one process: a crash is the sanitizers' to describe.
    SRunner *runner = srunner_create(suite);
    srunner_set_fork_status(runner, CK_NOFORK);
    srunner_run_all(runner, CK_SILENT);
    bool passed =
        srunner_ntests_run(runner) > 0 && srunner_ntests_failed(runner) == 0;
    srunner_free(runner);
    FILE *out = open_told();
    fputs(passed ? "passed\n" : "no test has passed\n", out);
    fclose(out);
    return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
