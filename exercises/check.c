#include "check.h"

#include "judge.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    TEXT = 2000,
    TEXTS = 16
};

void check_run(size_t times, void test(int _i))
{
    for (size_t i = 0; i < times; i++)
        test((int)i);
}

void check_input(const char *format, ...)
{
    char input[TEXT];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(input, sizeof input, format, arguments);
    va_end(arguments);
    judge_note_input(input);
}

static void append_row(char *text, int axes, const tf_event *event)
{
    for (int k = 0; k < axes; k++) {
        size_t length = strlen(text);
        snprintf(text + length, TEXT - length, "%c%a", k == 0 ? '\n' : ',',
                 event->x[k]);
    }
}

void check_picture(int axes, int first, const tf_worldline a[], int second,
                   const tf_worldline b[])
{
    char text[TEXT];
    snprintf(text, sizeof text, "%s-%s", first == 1 ? "point" : "edge",
             second == 2 ? "edge" : "triangle");
    for (int t = 0; t < 2; t++) {
        for (int i = 0; i < first; i++)
            append_row(text, axes, &a[i].at[t]);
        for (int i = 0; i < second; i++)
            append_row(text, axes, &b[i].at[t]);
    }
    judge_note_picture(text);
}

void check_at(const char *file, int line, bool good, const char *expected,
              const char *got, ...)
{
    if (good)
        return;
    char text[TEXT], where[TEXT];
    va_list arguments;
    va_start(arguments, got);
    vsnprintf(text, sizeof text, got, arguments);
    va_end(arguments);
    snprintf(where, sizeof where, "%s:%d", file, line);
    judge_fail(expected, text, where);
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
