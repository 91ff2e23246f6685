#include "check.h"

double first_meeting(const double p[2], const double q[2]);

typedef struct meeting {
    double p[2], q[2], t;
} meeting;

static const meeting expected[] = {
    {{0, 4}, {4, 0}, 0.5},  {{0, 4}, {1, 1}, 0.25}, // head-on, at rest
    {{4, 0}, {1, 1}, 0.75}, {{0, 3}, {1, 3}, 1},    // from above, at the end
    {{2, 5}, {2, 9}, 0},    {{2, 2}, {2, 2}, 0},    // at the start, at rest
    {{0, 5}, {0, 5}, 0},    {{0, 5}, {1, 6}, -1},   // together, in parallel
    {{0, 1}, {4, 3}, -1},   {{4, 3}, {0, 1}, -1},   // meet later
    {{0, 0}, {1, 2}, -1},   {{0, -1}, {1, 2}, -1},  // met before
    {{5, 0}, {0, 0}, 1},    {{-3, 3}, {0, 0}, 0.5},
};

TEST(is_the_first_time)
{
    const meeting *given = &expected[_i];
    check_input("p: %g to %g, q: %g to %g", given->p[0], given->p[1],
                given->q[0], given->q[1]);
    double got;
    check_value(got, first_meeting(given->p, given->q));
    check_real(given->t, got);
}

void run_tests(void)
{
    check_run(sizeof expected / sizeof *expected, is_the_first_time);
}
