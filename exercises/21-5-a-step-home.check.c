#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

void propose(int count, const double input[], const double x[], double fraction,
             double end[]);

bool accept(int count, const double input[], const double end[], double x[]);

enum {
    MOST = 12 ///< numbers of a state
};

/// "(1, 2)", with as many numbers as the state has.
static void list(char text[400], int count, const double x[])
{
    char *at = text;
    for (int i = 0; i < count; i++)
        at += sprintf(at, "%s%.17g", i == 0 ? "(" : ", ", x[i]);
    sprintf(at, ")");
}

/// Expects the same bits.
static void expect_same(int count, const double expected[], const double got[])
{
    char right[400], wrong[400];
    list(right, count, expected);
    list(wrong, count, got);
    check_that(memcmp(expected, got, (size_t)count * sizeof *got) == 0, right,
               "%s", wrong);
}

static void expect_end(int count, const double input[], const double x[],
                       double fraction, const double expected[])
{
    char of_input[400], of_x[400];
    list(of_input, count, input);
    list(of_x, count, x);
    check_input("propose(): input = %s, x = %s, fraction = %s", of_input, of_x,
                text_real(fraction));
    double end[MOST];
    for (int i = 0; i < MOST; i++)
        end[i] = NAN;
    check_call(end, propose(count, input, x, fraction, end));
    expect_same(count, expected, end);
}

static void expect_choice(bool taken, int count, const double input[],
                          const double x[], const double end[])
{
    char of_input[400], of_x[400], of_end[400];
    list(of_input, count, input);
    list(of_x, count, x);
    list(of_end, count, end);
    check_input("accept(): input = %s, x = %s, end = %s", of_input, of_x,
                of_end);
    double got[MOST] = {0};
    memcpy(got, x, (size_t)count * sizeof *got);
    bool answer;
    check_value(answer, accept(count, input, end, got));
    check_also(got);
    check_bool(taken, answer);
    expect_same(count, taken ? end : x, got);
}

TEST(a_part_of_the_way)
{
    expect_end(3, (double[]){0, 4, 1}, (double[]){2, 0, 1}, 0.25,
               (double[]){1.5, 1, 1});
    expect_end(2, (double[]){-8, 3}, (double[]){8, 5}, 0.125,
               (double[]){6, 4.75});
}

TEST(the_whole_way)
{
    expect_end(2, (double[]){0.5, 0}, (double[]){-2, 7}, 1, (double[]){0.5, 0});
    expect_end(3, (double[]){0.1, -0.3, 1e-20}, (double[]){0.7, 11, 3}, 1,
               (double[]){0.1, -0.3, 1e-20});
}

TEST(at_home)
{
    expect_end(3, (double[]){0, -0.0, 4}, (double[]){0, -0.0, 0}, 0.5,
               (double[]){0, -0.0, 2});
    expect_end(2, (double[]){0.1, 1e300}, (double[]){0.1, 1e300}, 0.3,
               (double[]){0.1, 1e300});
}

TEST(nearer)
{
    expect_choice(true, 2, (double[]){0, 0}, (double[]){3, 4},
                  (double[]){3, 3});
    // One vertex is farther off than before, and the sum has fallen.
    expect_choice(true, 2, (double[]){0, 0}, (double[]){8, 1},
                  (double[]){4, 6});
}

TEST(not_nearer)
{
    expect_choice(false, 2, (double[]){0, 0}, (double[]){3, 4},
                  (double[]){0, 6});
    expect_choice(false, 2, (double[]){0, 0}, (double[]){8, 1},
                  (double[]){5, 7});
    expect_choice(false, 3, (double[]){0.1, 0.2, 0.3},
                  (double[]){0.7, -0.0, 1e-30}, (double[]){0.1, 4, 0.3});
}

TEST(no_gain)
{
    expect_choice(false, 2, (double[]){1, 1}, (double[]){4, 5},
                  (double[]){5, 4});
    expect_choice(false, 2, (double[]){0, 0}, (double[]){25, 0},
                  (double[]){7, -24});
    expect_choice(false, 1, (double[]){3}, (double[]){3}, (double[]){3});
}

TEST(some_at_random)
{
    generator random = generator_new(21);
    for (int times = 0; times < 400; times++) {
        int count = 1 + below(&random, MOST), before = 0, after = 0;
        double input[MOST], x[MOST], end[MOST], right[MOST];
        double whole[MOST];
        for (int i = 0; i < count; i++) {
            int home = below(&random, 41) - 20, at = below(&random, 41) - 20;
            at = below(&random, 4) ? at : home;
            int to = at + below(&random, 21) - 10;
            before += (at - home) * (at - home);
            after += (to - home) * (to - home);
            input[i] = home;
            x[i] = at;
            end[i] = to;
            right[i] = at + (home - at) / 8.0;
            whole[i] = uniform(&random, -1, 1);
        }
        expect_end(count, input, x, 0.125, right);
        expect_end(count, whole, x, 1, whole);
        expect_choice(after < before, count, input, x, end);
    }
}

void run_tests(void)
{
    check_run(1, a_part_of_the_way);
    check_run(1, the_whole_way);
    check_run(1, at_home);
    check_run(1, nearer);
    check_run(1, not_nearer);
    check_run(1, no_gain);
    check_run(1, some_at_random);
}
