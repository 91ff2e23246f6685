#include "check.h"

#include "intersect/complementary.h"

#include <stdio.h>
#include <string.h>

double time_of_impact(const tf_pair *pair, const double c[]);

typedef struct impact {
    int triangle; // of the edge's sweep: 0, pivot 1, or 1, pivot 0
    double c[5], t;
} impact;

// By the pair's events: first those at t = 0, the point's before the edge's.
static const impact expected[] = {
    {0, {3, -2, -1, 1, -1}, 0.25}, {0, {1, -1, 0, 1, -1}, 0.5},
    {0, {6, -4, -2, 2, -2}, 0.25}, {0, {-0.5, 0.5, 0, -1.5, 1.5}, 0.75},
    {1, {1, -1, 3, -2, -1}, 0.75}, {1, {0, 0, 5, -1, -4}, 1},
    {1, {2, -2, 0, 0, 0}, 0},
};

TEST(is_the_time_of_the_common_event)
{
    const impact *given = &expected[_i];
    tf_worldline point = {.at = {{.t = 0}, {.t = 1}}};
    tf_worldline edge[2] = {point, point};
    tf_simplex s[1], r[2];
    tf_sweep(1, &point, s);
    tf_sweep(2, edge, r);
    tf_pair pair = tf_pair_of(&s[0], &r[given->triangle], 2);
    char text[200] = "";
    for (int i = 0; i < pair.count; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "\n%s of the %s at t = %d", text_real(given->c[i]),
                 pair.operand[i] > 0 ? "point" : "edge", pair.event[i]->t);
    check_input("c and the events:%s", text);
    double got;
    check_value(got, time_of_impact(&pair, given->c));
    check_near(given->t, got, 1e-15);
}

void run_tests(void)
{
    check_run(sizeof expected / sizeof *expected,
              is_the_time_of_the_common_event);
}
