#include "check.h"

#include <math.h>

double advance_bar(double radius, double ahead, double turn, double threshold,
                   int *steps);

typedef struct advance {
    double radius, ahead, turn, threshold;
} advance;

static const advance given[] = {
    {0.5, 1, 1.5, 0.5},  {0.5, 1, 1.5, 0.2},    {0.5, 1, 1.5, 1e-3},
    {0.5, 1, 1.5, 1e-9}, {0.9, 1, 1.5, 1e-9},   {0.1, 1.2, 2, 1e-3},
    {0.1, 1.2, 2, 1e-6}, {0.25, 0.75, 3, 1e-6},
};

/// The number of advances; of an angle a that is left each leaves a - r sin a.
static int count_advances(const advance *g)
{
    int steps = 0;
    for (double left = g->ahead; g->radius * sin(left) > g->threshold; steps++)
        left -= g->radius * sin(left);
    return steps;
}

TEST(ends_at_the_threshold)
{
    const advance *g = &given[_i];
    int steps = -1;
    check_input("radius %g, %g radians ahead, turn %g, threshold %g", g->radius,
                g->ahead, g->turn, g->threshold);
    double t;
    check_value(
        t, advance_bar(g->radius, g->ahead, g->turn, g->threshold, &steps));
    check_also(steps);
    check_that(t <= g->ahead / g->turn, "a time before the contact", "%s",
               text_real(t));
    double distance = g->radius * sin(g->ahead - g->turn * t);
    check_that(distance <= g->threshold * (1 + 1e-9), "the threshold reached",
               "distance %s", text_real(distance));
    check_that(steps == count_advances(g), text_real(count_advances(g)), "%d",
               steps);
}

TEST(ends_with_the_step)
{
    int steps = -1;
    check_input("radius 0.5, 1.5 radians ahead, turn 1, threshold 0.1");
    double t;
    check_value(t, advance_bar(0.5, 1.5, 1, 0.1, &steps));
    check_also(steps);
    check_that(t == 1, "1", "%s", text_real(t));
    check_that(steps == 3, "3", "%d", steps);
}

void run_tests(void)
{
    check_run(sizeof given / sizeof *given, ends_at_the_threshold);
    check_run(1, ends_with_the_step);
}
