// What the checks of all exercises share: they show what a student's function
// was given, what was expected of it and what it returned.
//
// The same checks run in two processes at once.  The answer's process contains
// the student's code; the judge does not.  Where the checks call that code, by
// check_call(), only the answer's process makes the call, and the judge receives
// the bytes of the result.  It alone compares them, and decides.  So an answer
// has nothing that it could forge but its own results.  Both processes must do
// the same up to the first failure, which ends them: no check may depend on
// addresses, the clock or anything else in which they differ.
//
// A check file has tests, TEST(name) { ... }, and a function run_tests() that runs
// them; main() is in judge.c.
#ifndef EXERCISES_CHECK_H
#define EXERCISES_CHECK_H

#include "geometry/event.h"

#include <stdbool.h>
#include <stddef.h>

/// A test, a function of the number of the run.
#define TEST(name) static void name(int _i __attribute__((unused)))

/// Run all tests of the exercise, by check_run().  Defined by each check file.
void run_tests(void);

/// Run a test a number of times, with _i = 0, 1, ...
void check_run(size_t times, void test(int _i));

/// Let the answer's process make a call; take the bytes of `result`, a variable
/// or array, which it leaves its result in.
#define check_call(result, ...)                                                \
    do {                                                                       \
        if (check_makes_calls()) {                                             \
            __VA_ARGS__;                                                       \
        }                                                                      \
        check_take(&(result), sizeof(result));                                 \
    } while (0)

/// The same of a call that returns its result.
#define check_value(result, ...) check_call(result, (result) = __VA_ARGS__)

/// The same of a call that leaves `count` elements where `result` points.
#define check_call_n(count, result, ...)                                       \
    do {                                                                       \
        if (check_makes_calls()) {                                             \
            __VA_ARGS__;                                                       \
        }                                                                      \
        check_take(result, (count) * sizeof *(result));                        \
    } while (0)

/// Take another variable or array that the last call has left something in.
#define check_also(result) check_take(&(result), sizeof(result))

/// Whether this is the answer's process.
bool check_makes_calls(void);

/// Hand the bytes over: from the answer's process to the judge.
void check_take(void *result, size_t size);

/// Note, before the call, what the student's function is given.
void check_input(const char *format, ...) __attribute__((format(printf, 1, 2)));

/// Note, after check_input(), that the input is a query of two elements, which
/// can be drawn: a point and an edge in the plane, a point and a triangle, or two
/// edges, each of as many vertices as it has.
void check_picture(int axes, int first, const tf_worldline a[], int second,
                   const tf_worldline b[]);

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

// Words for what is shown.  They stay good for the next fifteen such calls.

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
