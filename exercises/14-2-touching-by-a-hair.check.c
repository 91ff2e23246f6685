#include "check.h"

#include "support/support.h"

#include <math.h>

bool touch(const double first[2], const double second[2]);

/// The float nearest to x, by a look at its neighbors; of two as near, the one
/// that conversion takes.
static float nearest(double x)
{
    float at = (float)x;
    float around[] = {nextafterf(at, -2), nextafterf(at, 2)};
    for (int i = 0; i < 2; i++)
        if (fabs((double)around[i] - x) < fabs((double)at - x))
            at = around[i];
    return at;
}

static void expect(const double first[2], const double second[2])
{
    float low = fmaxf(nearest(first[0]), nearest(second[0]));
    float high = fminf(nearest(first[1]), nearest(second[1]));
    check_input("first = %s, second = %s", text_point(2, first),
                text_point(2, second));
    bool got;
    check_value(got, touch(first, second));
    check_bool(low <= high, got);
}

static void expect_both(const double first[2], const double second[2])
{
    expect(first, second);
    expect(second, first);
}

TEST(clearly)
{
    expect_both((double[]){0, 0.25}, (double[]){0.5, 0.75});
    expect_both((double[]){0, 0.5}, (double[]){0.25, 0.75});
    expect_both((double[]){0, 0.75}, (double[]){0.25, 0.5});
    expect_both((double[]){0, 0.5}, (double[]){0.5, 0.75});
}

TEST(by_a_hair)
{
    // Less than half a spacing of floats apart, and a little more.
    expect_both((double[]){0, 0.75}, (double[]){0.75 + 0x1p-27, 0.875});
    expect_both((double[]){0, 0.75}, (double[]){0.75 + 0x1.1p-25, 0.875});
    expect_both((double[]){0, 0}, (double[]){0x1p-160, 0.5});
}

TEST(anywhere_near)
{
    generator random = generator_new(0);
    for (int i = 0; i < 3000; i++) {
        double at = uniform(&random, -0.9, 0.9);
        double gap = ldexp(uniform(&random, -1, 1), -24 - below(&random, 6));
        double first[2] = {at - uniform(&random, 0, 0.05), at};
        double second[2] = {at + gap, at + gap + uniform(&random, 0, 0.05)};
        expect_both(first, second);
    }
}

void run_tests(void)
{
    check_run(1, clearly);
    check_run(1, by_a_hair);
    check_run(1, anywhere_near);
}
