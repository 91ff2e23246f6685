#include "check.h"

#include "support/support.h"

#include <float.h>
#include <math.h>

bool all_finite(int count, const double x[]);

enum {
    MOST = 24
};

static void expect(bool expected, int count, const double x[])
{
    int special = 0;
    for (int i = 0; i < count; i++)
        if (!isfinite(x[i]))
            special = i;
    check_input("%d numbers, x[%d] = %g", count, special, x[special]);
    bool got;
    check_value(got, all_finite(count, x));
    check_bool(expected, got);
}

static const double limits[] = {0.0,      -0.0,    1,           DBL_MAX,
                                -DBL_MAX, DBL_MIN, DBL_TRUE_MIN};

enum {
    LIMITS = sizeof limits / sizeof *limits
};

TEST(finite_ones)
{
    generator random = generator_new(1);
    expect(true, 2, (double[]){DBL_MAX, DBL_MAX});
    expect(true, 2, (double[]){-DBL_MAX, -DBL_MAX});
    for (int n = 0; n < 1000; n++) {
        double x[MOST];
        int count = 1 + below(&random, MOST);
        for (int i = 0; i < count; i++)
            x[i] = limits[below(&random, LIMITS)];
        expect(true, count, x);
    }
}

TEST(one_that_is_not)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    generator random = generator_new(2);
    for (int n = 0; n < 1000; n++) {
        double x[MOST];
        int count = 1 + below(&random, MOST);
        for (int i = 0; i < count; i++)
            x[i] = limits[below(&random, LIMITS)];
        x[below(&random, count)] = bad[below(&random, 3)];
        expect(false, count, x);
    }
}

TEST(several_that_are_not)
{
    expect(false, 2, (double[]){INFINITY, -INFINITY});
    expect(false, 3, (double[]){-INFINITY, 1, INFINITY});
    expect(false, 2, (double[]){NAN, -NAN});
}

void run_tests(void)
{
    check_run(1, finite_ones);
    check_run(1, one_that_is_not);
    check_run(1, several_that_are_not);
}
