#include "check.h"

#include "support/support.h"

#include <math.h>

void find_gradient(const double along[3], const double normal[3], int segments,
                   const double segment[][3], double gradient[3]);

/// Where an edge pierces a triangle, and where its curve goes on from there.
typedef struct crossing {
    double along[3], normal[3];
    int segments;
    double segment[2][3];
} crossing;

static double product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void find(const crossing *c, double gradient[3])
{
    if (c->segments == 2)
        check_input("along = %s, normal = %s, segments %s and %s",
                    text_point(3, c->along), text_point(3, c->normal),
                    text_point(3, c->segment[0]), text_point(3, c->segment[1]));
    else
        check_input("along = %s, normal = %s, segment %s",
                    text_point(3, c->along), text_point(3, c->normal),
                    text_point(3, c->segment[0]));
    for (int k = 0; k < 3; k++)
        gradient[k] = NAN;
    check_call_n(
        3, gradient,
        find_gradient(c->along, c->normal, c->segments, c->segment, gradient));
}

static void expect(double x, double y, double z, const crossing *c)
{
    double gradient[3];
    find(c, gradient);
    check_point(3, ((const double[]){x, y, z}), gradient, 1e-14);
}

TEST(an_upright_edge)
{
    expect(1, 0, 0, &(crossing){{0, 0, 1}, {0, 0, 1}, 1, {{3, 0, 0}}});
    expect(0.6, 0.8, 0, &(crossing){{0, 0, 2}, {0, 0, -5}, 1, {{3, 4, 0}}});
}

TEST(a_straight_curve)
{
    // No displacement makes it shorter.
    expect(0, 0, 0,
           &(crossing){{0, 0, 1}, {0, 0, 1}, 2, {{2, 0, 0}, {-7, 0, 0}}});
}

TEST(a_corner)
{
    expect(1.6, 0.8, 0,
           &(crossing){{0, 0, 1}, {0, 0, 1}, 2, {{2, 0, 0}, {6, 8, 0}}});
    expect(0.6 - 5.0 / 13, 0.8 + 12.0 / 13, 0,
           &(crossing){{0, 0, 1}, {0, 0, 3}, 2, {{3, 4, 0}, {-5, 12, 0}}});
}

TEST(a_slanting_edge)
{
    // Down by 1, the edge pierces the plane 1 further along.
    expect(1, 0, -1, &(crossing){{1, 0, 1}, {0, 0, 1}, 1, {{4, 0, 0}}});
    expect(1, 0, 3, &(crossing){{-3, 0, 1}, {0, 0, 1}, 1, {{4, 0, 0}}});
    expect(0.6, 0.8, -1, &(crossing){{3, 4, 5}, {0, 0, 7}, 1, {{3, 4, 0}}});
    expect(0, 1.6, -0.8,
           &(crossing){{5, 1, 2}, {0, 0, -2}, 2, {{3, 4, 0}, {-12, 16, 0}}});
}

/// How much shorter the curve is after a displacement.
static double gain(const crossing *c, const double displacement[3])
{
    double slide =
        product(c->normal, displacement) / product(c->normal, c->along);
    double sum = 0;
    for (int i = 0; i < c->segments; i++) {
        double left[3];
        for (int k = 0; k < 3; k++)
            left[k] = c->segment[i][k] - displacement[k] + slide * c->along[k];
        sum += sqrt(product(c->segment[i], c->segment[i])) -
               sqrt(product(left, left));
    }
    return sum;
}

TEST(some_at_random)
{
    generator random = generator_new(21);
    for (int times = 0; times < 400; times++) {
        crossing c = {.segments = 1 + below(&random, 2)};
        for (int k = 0; k < 3; k++) {
            c.along[k] = uniform(&random, -1, 1);
            c.normal[k] = uniform(&random, -1, 1);
        }
        double square = product(c.normal, c.normal);
        if (square < 0.1 || fabs(product(c.normal, c.along)) < 0.1)
            continue;
        for (int i = 0; i < c.segments; i++) {
            double *s = c.segment[i];
            for (int k = 0; k < 3; k++)
                s[k] = (k == 0 ? 1 : 0) + uniform(&random, -1, 1);
            double part = product(s, c.normal) / square;
            for (int k = 0; k < 3; k++)
                s[k] -= part * c.normal[k];
            double length = sqrt(product(s, s));
            for (int k = 0; k < 3; k++)
                s[k] = length < 0.1 ? c.normal[(k + 1) % 3] : s[k];
        }
        double expected[3], gradient[3];
        for (int k = 0; k < 3; k++) {
            double by[3] = {0}, back[3] = {0};
            by[k] = 1e-5;
            back[k] = -1e-5;
            expected[k] = (gain(&c, by) - gain(&c, back)) / 2e-5;
        }
        find(&c, gradient);
        check_point(3, expected, gradient, 1e-4);
    }
}

void run_tests(void)
{
    check_run(1, an_upright_edge);
    check_run(1, a_straight_curve);
    check_run(1, a_corner);
    check_run(1, a_slanting_edge);
    check_run(1, some_at_random);
}
