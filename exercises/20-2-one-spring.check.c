#include "check.h"

#include "support/support.h"

#include <math.h>

void iterate(double m, double k, double r, double h, const double y[2],
             double z[2]);

typedef struct spring {
    double m, k, r, h, y[2];
} spring;

static void run(const spring *s, double z[2])
{
    check_input("m = %s, k = %s, r = %s, h = %s, y = %s, z = %s",
                text_real(s->m), text_real(s->k), text_real(s->r),
                text_real(s->h), text_point(2, s->y), text_point(2, z));
    check_call_n(2, z, iterate(s->m, s->k, s->r, s->h, s->y, z));
}

static double objective(const spring *s, const double z[2])
{
    double off = hypot(z[0] - s->y[0], z[1] - s->y[1]);
    double amiss = hypot(z[0], z[1]) - s->r;
    return s->m / (2 * s->h * s->h) * off * off + s->k / 2 * amiss * amiss;
}

TEST(one_iteration)
{
    // m = h^2 k: half of y and half of the wanted sum.
    const spring s = {1, 4, 2, 0.5, {3, 0}};
    double z[2] = {0, 8};
    run(&s, z);
    check_point(2, ((const double[]){1.5, 1}), z, 1e-15);
}

TEST(stiffer_and_lighter)
{
    const spring s = {1, 300, 1, 0.1, {0, 2}};
    double z[2] = {0, 2};
    run(&s, z);
    check_point(2, ((const double[]){0, 1.25}), z, 1e-15);
}

TEST(at_the_origin)
{
    const spring s = {1, 4, 2, 0.5, {3, -1}};
    double z[2] = {0, 0};
    run(&s, z);
    check_point(2, ((const double[]){1.5, -0.5}), z, 1e-15);
}

TEST(at_rest)
{
    const spring s = {2, 50, 1.5, 0.1, {0.9, 1.2}};
    double z[2] = {0.9, 1.2};
    run(&s, z);
    check_point(2, s.y, z, 1e-15);
}

TEST(it_never_gets_worse)
{
    generator random = generator_new(0);
    for (int i = 0; i < 60; i++) {
        spring s = {uniform(&random, 0.1, 2),
                    pow(10, uniform(&random, 0, 5)),
                    uniform(&random, 0.5, 2),
                    uniform(&random, 0.01, 0.1),
                    {uniform(&random, -3, 3), uniform(&random, -3, 3)}};
        double z[2] = {uniform(&random, -3, 3), uniform(&random, -3, 3)};
        for (int n = 0; n < 10; n++) {
            double before = objective(&s, z);
            run(&s, z);
            double after = objective(&s, z);
            check_that(after <= before * (1 + 1e-12) + 1e-12,
                       "an objective that does not rise", "%.17g after %.17g",
                       after, before);
        }
    }
}

TEST(it_ends_at_the_least)
{
    const spring s = {1, 1000, 1, 0.1, {1.5, 2}};
    double z[2] = {3, 4};
    for (int n = 0; n < 200; n++)
        run(&s, z);
    // On the ray through y, where m / h^2 (z - y) is the force of the spring.
    double length = (2.5 + 10 * 1) / 11;
    check_point(2, ((const double[]){0.6 * length, 0.8 * length}), z, 1e-9);
}

void run_tests(void)
{
    check_run(1, one_iteration);
    check_run(1, stiffer_and_lighter);
    check_run(1, at_the_origin);
    check_run(1, at_rest);
    check_run(1, it_never_gets_worse);
    check_run(1, it_ends_at_the_least);
}
