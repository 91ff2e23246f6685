// What the checks of all exercises share: they tell what a student's function
// was given, what was expected of it and what it gave.  A check file defines
// add_tests(); main() is in check.c, and the first failure ends the program.
#ifndef EXERCISES_CHECK_H
#define EXERCISES_CHECK_H

#include "geometry/event.h"

#include <check.h>
#include <stdbool.h>

/// Add the tests of the exercise.  Defined by each check file.
void add_tests(TCase *tests);

/// Tell, before the call, what the student's function is given.
void check_input(const char *format, ...) __attribute__((format(printf, 1, 2)));

/// Fail unless `good`; `got`, and what follows as for printf, says what came.
#define check_that(good, expected, ...)                                        \
    check_at(__FILE__, __LINE__, good, expected, __VA_ARGS__)

/// Fail unless two numbers are equal.
#define check_real(expected, got) check_near(expected, got, 0)

/// Fail unless two numbers are at most `tolerance` apart.
#define check_near(expected, got, tolerance)                                   \
    check_near_at(__FILE__, __LINE__, expected, got, tolerance)

/// Fail unless two points of n coordinates, n = 1 to 3, are at most `tolerance`
/// apart on each axis.
#define check_point(n, expected, got, tolerance)                               \
    check_point_at(__FILE__, __LINE__, n, expected, got, tolerance)

/// Fail unless the coordinates of worldlines are finite.
#define check_finite(axes, count, lines)                                       \
    check_finite_at(__FILE__, __LINE__, axes, count, lines)

/// Fail unless two answers to a question are the same.
#define check_bool(expected, got)                                              \
    check_that((expected) == (got), (expected) ? "true" : "false",             \
               (got) ? "true" : "false")

void check_at(const char *file, int line, bool good, const char *expected,
              const char *got, ...) __attribute__((format(printf, 5, 6)));
void check_near_at(const char *file, int line, double expected, double got,
                   double tolerance);
void check_point_at(const char *file, int line, int n, const double expected[],
                    const double got[], double tolerance);
void check_finite_at(const char *file, int line, int axes, int count,
                     const tf_worldline lines[]);

// Words for what is told.  They stay good for the next fifteen such calls.

/// The shortest decimals that read back as x.
const char *text_real(double x);

/// "(1, 2)".
const char *text_point(int n, const double x[]);

/// "(1, 2) -> (3, 4)".
const char *text_line(int axes, const tf_worldline *line);

/// Worldlines, a line each, with a name before them.
const char *text_lines(int axes, const char *name, int count,
                       const tf_worldline lines[]);

/// The word for a sign: "negative", "zero", "positive" or "unknown".
const char *text_sign(int sign);

#endif
