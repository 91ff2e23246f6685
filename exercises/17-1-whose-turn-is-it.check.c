#include "check.h"

#include "support/queries.h"
#include "support/support.h"

#include <stdio.h>

void shares(int count, const double coordinate[], double t, double share[]);

static void ask(int count, const double coordinate[], double t, double share[])
{
    check_input("coordinates %s, t = %s", text_point(count, coordinate),
                text_real(t));
    for (int i = 0; i < count; i++)
        share[i] = -1;
    check_call_n((size_t)count, share, shares(count, coordinate, t, share));
}

TEST(as_in_the_book)
{
    const double coordinate[] = {0.25, 0.5, 0.25};
    const double expected[][3] = {{0, 0, 0},      {0, 0, 0.125},
                                  {0, 0, 0.25},   {0, 0.25, 0.25},
                                  {0, 0.5, 0.25}, {0.25, 0.5, 0.25}};
    const double time[] = {0, 0.125, 0.25, 0.5, 0.75, 1};
    for (int i = 0; i < 6; i++) {
        double got[3];
        ask(3, coordinate, time[i], got);
        check_point(3, expected[i], got, 0);
    }
}

/// Where the dot is if only the vertex i moves, by 1.
static double pulled(int count, const double coordinate[], double t, int i)
{
    const double origin[2] = {0, 0}, one[2] = {1, 0};
    tf_worldline vertex[3];
    for (int v = 0; v < count; v++)
        vertex[v] = tf_worldline_between(2, origin, v == i ? one : origin);
    double place[2];
    staircase_point(2, count, vertex, coordinate, t, place);
    return place[0];
}

TEST(as_the_staircase_has_it)
{
    generator random = generator_new(0);
    for (int trial = 0; trial < 300; trial++) {
        int count = 1 + below(&random, 3);
        double coordinate[3], sum = 0, got[3], expected[3];
        for (int i = 0; i < count; i++)
            sum += coordinate[i] = uniform(&random, 0, 1);
        for (int i = 0; i < count; i++)
            coordinate[i] /= sum;
        double t = uniform(&random, 0, 1);
        for (int i = 0; i < count; i++)
            expected[i] = pulled(count, coordinate, t, i);
        ask(count, coordinate, t, got);
        check_point(count, expected, got, 1e-14);
    }
}

void run_tests(void)
{
    check_run(1, as_in_the_book);
    check_run(1, as_the_staircase_has_it);
}
