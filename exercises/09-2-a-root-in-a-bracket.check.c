#include "check.h"

#include "support/support.h"

#include <math.h>

double root_between(const double c[3], double lo, double hi);
double value(const double c[3], double t);

static int evaluations;

/// What the student's function calls, too.
double value(const double c[3], double t)
{
    evaluations++;
    check_that(evaluations <= 1000, "at most 100 evaluations", "more");
    return (c[2] * t + c[1]) * t + c[0];
}

static bool changes_sign(const double c[3], double t, double other)
{
    return (value(c, t) > 0) != (value(c, other) > 0);
}

static void expect_root(const double c[3], double lo, double hi)
{
    check_input("%s + %s t + %s t^2 between %s and %s", text_real(c[0]),
                text_real(c[1]), text_real(c[2]), text_real(lo), text_real(hi));
    evaluations = 0;
    double t;
    check_value(t, root_between(c, lo, hi));
    check_also(evaluations);
    check_that(evaluations <= 100, "at most 100 evaluations", "%d",
               evaluations);
    check_that(t >= lo && t <= hi, "a time in the bracket", "%s", text_real(t));
    check_that(value(c, t) == 0 || changes_sign(c, t, nextafter(t, 2)) ||
                   changes_sign(c, t, nextafter(t, -1)),
               "a change of sign at the last bit", "%s", text_real(t));
}

TEST(finds_the_root_of_the_running_example)
{
    expect_root((const double[]){12, -17, -1}, 0, 1);
}

TEST(finds_roots_where_newton_leaves_the_bracket)
{
    // Nearly flat at one end: Newton's step from there goes far away.
    expect_root((const double[]){-0x1p-40, 0, 1}, 0, 1);
    expect_root((const double[]){0x1p-40, -0x1p-60, -1}, 0, 1);
    expect_root((const double[]){1e-3, -2, 1}, 0, 1);
    expect_root((const double[]){1, -0x1.00001p0, 0x1p-21}, 0, 1);
}

TEST(finds_small_roots)
{
    expect_root((const double[]){-1e-20, 1, 1}, 0, 1);
    expect_root((const double[]){-1e-15, 1e-3, 1}, 0, 1);
}

TEST(finds_random_roots)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        double apex = below(&random, 2) ? uniform(&random, -3, 0)
                                        : uniform(&random, 1, 4);
        double root = uniform(&random, 0, 1);
        // (t - apex)^2 - (root - apex)^2, monotone from 0 to 1.
        double c[3] = {apex * apex - (root - apex) * (root - apex), -2 * apex,
                       1};
        evaluations = 0;
        if (changes_sign(c, 0, 1))
            expect_root(c, 0, 1);
    }
}

void run_tests(void)
{
    check_run(1, finds_the_root_of_the_running_example);
    check_run(1, finds_roots_where_newton_leaves_the_bracket);
    check_run(1, finds_small_roots);
    check_run(1, finds_random_roots);
}
