#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    BODIES = 3
};

void visit(int count, const double coefficient[], const double inverse_mass[],
           double bound, double *impulse, double move[]);

static void ask(const double coefficient[], const double inverse_mass[],
                double bound, double *impulse, double move[])
{
    check_input("coefficients %s, inverse masses %s, bound %s, impulse so far "
                "%s, moves %s",
                text_point(BODIES, coefficient),
                text_point(BODIES, inverse_mass), text_real(bound),
                text_real(*impulse), text_point(BODIES, move));
    check_call_n(
        BODIES, move,
        visit(BODIES, coefficient, inverse_mass, bound, impulse, move));
    check_also(*impulse);
}

static void check_impulse(double expected, double got)
{
    char text[60];
    snprintf(text, sizeof text, "the impulse %.17g", expected);
    check_that(fabs(got - expected) <= 1e-12, text, "%s", text_real(got));
}

/// The plate and the two stones of the chapter, one visit after another.
TEST(stones_and_plate)
{
    const double ones[] = {1, 1, 1};
    const double slow[] = {-1, 0, 1}, fast[] = {0, -1, 1};
    const double expected[][BODIES] = {
        {0.5, 3, 0.5}, {0.5, 1.75, 1.75}, {1, 1.75, 1.25}, {1, 1.5, 1.5}};
    const double impulses[] = {0.5, 1.25, 0, 1.5};
    double move[] = {1, 3, 0}, impulse[2] = {0, 0};
    for (int i = 0; i < 4; i++) {
        ask(i % 2 == 0 ? slow : fast, ones, 0, &impulse[i % 2], move);
        check_point(BODIES, expected[i], move, 1e-12);
        check_impulse(impulses[i], impulse[i % 2]);
    }
}

TEST(what_cannot_be_moved)
{
    const double constraint[] = {1, -1, 0};
    double move[] = {0, 1, 0}, impulse = 0;
    ask(constraint, (double[]){0, 0, 1}, 0, &impulse, move);
    check_point(BODIES, ((const double[]){0, 1, 0}), move, 0);
    check_impulse(0, impulse);
    ask(constraint, (double[]){0, 1, 1}, 0, &impulse, move);
    check_point(BODIES, ((const double[]){0, 0, 0}), move, 1e-15);
    check_impulse(1, impulse);
    impulse = 2;
    ask(constraint, (double[]){0, 0, 1}, 0, &impulse, move);
    check_point(BODIES, ((const double[]){0, 0, 0}), move, 1e-15);
    check_impulse(2, impulse);
}

/// The impulse is 0 or the constraint has exactly what it wants, and the bodies
/// have been pushed by what was added.
TEST(anything)
{
    generator random = generator_new(0);
    for (int trial = 0; trial < 300; trial++) {
        double constraint[BODIES], inverse_mass[BODIES], move[BODIES],
            before[BODIES];
        double impulse = uniform(&random, 0, 2), old = impulse;
        double bound = uniform(&random, 0, 1);
        for (int i = 0; i < BODIES; i++) {
            constraint[i] = uniform(&random, -1, 1);
            inverse_mass[i] = uniform(&random, 0.5, 2);
            move[i] = uniform(&random, -1, 1);
        }
        memcpy(before, move, sizeof move);
        ask(constraint, inverse_mass, bound, &impulse, move);
        check_that(impulse >= 0, "an impulse of 0 or more", "%s",
                   text_real(impulse));
        double sum = 0, expected[BODIES];
        for (int i = 0; i < BODIES; i++) {
            sum += constraint[i] * move[i];
            expected[i] =
                before[i] + (impulse - old) * constraint[i] * inverse_mass[i];
        }
        check_point(BODIES, expected, move, 1e-12);
        if (impulse > 0)
            check_that(fabs(sum - bound) <= 1e-9,
                       "the bound as the sum, as there is an impulse",
                       "the sum %s, not %s", text_real(sum), text_real(bound));
        else
            check_that(sum >= bound - 1e-9,
                       "a constraint that has what it wants", "%s, not %s",
                       text_real(sum), text_real(bound));
    }
}

void run_tests(void)
{
    check_run(1, stones_and_plate);
    check_run(1, what_cannot_be_moved);
    check_run(1, anything);
}
