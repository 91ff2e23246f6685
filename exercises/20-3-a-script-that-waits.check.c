#include "check.h"

#include <math.h>

void go_on(int count, const double end[], double step, int held,
           double position[], double velocity[], double *clock);

TEST(a_step)
{
    const double end[] = {1, 2.5, -1};
    double position[] = {0, 2, 0}, velocity[] = {7, 7, 7}, clock = 3;
    check_input("end = %s, step = 0.5, held = 0, position = %s, clock = 3",
                text_point(3, end), text_point(3, position));
    check_call(position, go_on(3, end, 0.5, 0, position, velocity, &clock));
    check_also(velocity);
    check_also(clock);
    check_point(3, end, position, 0);
    check_point(3, ((const double[]){2, 1, -2}), velocity, 1e-15);
    check_real(3.5, clock);
}

TEST(held_back)
{
    const double end[] = {0, 1};
    double position[] = {0, 0}, velocity[] = {1, 1}, clock = 1;
    check_input("end = %s, step = 0.25, held = 1, position = %s, clock = 1",
                text_point(2, end), text_point(2, position));
    check_call(position, go_on(2, end, 0.25, 1, position, velocity, &clock));
    check_also(velocity);
    check_also(clock);
    check_point(2, end, position, 0);
    check_point(2, ((const double[]){0, 4}), velocity, 1e-15);
    check_real(1, clock);
}

/// Where the hand should be.
static double script(double clock)
{
    return sin(clock);
}

/// The hand and what it pulls are stuck for some steps.
static void run(int stuck_from, int stuck_to)
{
    const double step = 0.01;
    double position[2] = {0, -1}, velocity[2] = {0, 0}, clock = 0;
    for (int i = 0; i < 300; i++) {
        bool stuck = i >= stuck_from && i < stuck_to;
        double hand = script(clock + step);
        check_input("step %d of 0.01 seconds, stuck from step %d to %d", i,
                    stuck_from, stuck_to);
        check_that(fabs(hand - position[0]) <= 1.0001 * step,
                   "a hand that is to move by 0.01 at most", "%.17g",
                   hand - position[0]);
        double end[2] = {stuck ? position[0] : hand,
                         stuck ? position[1] : hand - 1};
        double before = position[1];
        check_call(position, go_on(2, end, step, stuck ? 2 : 0, position,
                                   velocity, &clock));
        check_also(velocity);
        check_also(clock);
        check_near((end[1] - before) / step, velocity[1], 1e-12);
        check_real(end[1], position[1]);
    }
    check_near(0.01 * (300 - (stuck_to - stuck_from)), clock, 1e-9);
}

TEST(never_stuck)
{
    run(0, 0);
}

TEST(stuck_for_a_while)
{
    run(20, 80);
    run(0, 10);
}

void run_tests(void)
{
    check_run(1, a_step);
    check_run(1, held_back);
    check_run(1, never_stuck);
    check_run(1, stuck_for_a_while);
}
