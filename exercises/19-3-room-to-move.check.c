#include "check.h"

#include "arithmetic/exact.h"
#include "geometry/event.h"
#include "query/query.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>

double room(const double point[2], const double a[2], const double b[2]);

/// The distance of a point from an edge, by search.
static double distance_to(const double point[2], const double a[2],
                          const double b[2])
{
    double low = 0, high = 1;
    double nearest = 0;
    // The distance is a convex function of the weight.
    for (int i = 0; i < 200; i++) {
        double third = (high - low) / 3, value[2];
        for (int k = 0; k < 2; k++) {
            double w = low + (1 + k) * third;
            value[k] = hypot(a[0] + w * (b[0] - a[0]) - point[0],
                             a[1] + w * (b[1] - a[1]) - point[1]);
        }
        *(value[0] < value[1] ? &high : &low) =
            value[0] < value[1] ? high - third : low + third;
        nearest = fmin(value[0], value[1]);
    }
    return nearest;
}

static void tell(const double x[3][2])
{
    check_input("point = %s, a = %s, b = %s", text_point(2, x[0]),
                text_point(2, x[1]), text_point(2, x[2]));
}

/// Expects no contact if the vertices move by `by`, in these directions.
static void expect_clear(const double x[3][2], double by,
                         const double direction[3])
{
    tf_worldline line[3];
    for (int v = 0; v < 3; v++) {
        double end[2] = {x[v][0] + by * cos(direction[v]),
                         x[v][1] + by * sin(direction[v])};
        line[v] = tf_worldline_between(2, x[v], end);
    }
    tf_contact contact;
    tf_query(&tf_exact, 2, 1, line, 2, line + 1, &contact);
    char got[200];
    snprintf(got, sizeof got,
             "a contact if they move by %.17g in the directions %.3g, %.3g "
             "and %.3g",
             by, direction[0], direction[1], direction[2]);
    check_that(contact.verdict == TF_APART, "no contact", "%s", got);
}

static void expect(generator *random, const double x[3][2])
{
    double distance = distance_to(x[0], x[1], x[2]);
    tell(x);
    double r;
    check_value(r, room(x[0], x[1], x[2]));
    check_that(r >= 0.49 * distance && r <= 0.5 * distance,
               "between 0.49 and 0.5 of the distance", "%.17g of %.17g", r,
               distance);
    double straight = atan2((x[1][1] + x[2][1]) / 2 - x[0][1],
                            (x[1][0] + x[2][0]) / 2 - x[0][0]);
    double back = straight + acos(-1);
    expect_clear(x, r, (double[]){straight, back, back});
    for (int i = 0; i < 20; i++) {
        double direction[3];
        for (int v = 0; v < 3; v++)
            direction[v] = uniform(random, -acos(-1), acos(-1));
        expect_clear(x, r, direction);
    }
}

TEST(straight_at_each_other)
{
    // The point comes down by 1/4 and the edge up, each by as much as it may.
    const double x[3][2] = {{0, 0.25}, {-0.5, -0.25}, {0.5, -0.25}};
    tell(x);
    double r;
    check_value(r, room(x[0], x[1], x[2]));
    check_that(r >= 0.49 * 0.5, "at least 0.245", "%.17g", r);
    tf_worldline line[3];
    for (int v = 0; v < 3; v++)
        line[v] = tf_worldline_between(
            2, x[v], (double[]){x[v][0], x[v][1] + (v == 0 ? -r : r)});
    tf_contact contact;
    tf_query(&tf_exact, 2, 1, line, 2, line + 1, &contact);
    check_that(contact.verdict == TF_APART, "no contact if they move by it",
               "a contact if they move by %.17g", r);
}

TEST(beyond_an_end)
{
    generator random = generator_new(0);
    expect(&random, (const double[3][2]){{0.75, 0}, {-0.5, 0}, {0.5, 0}});
    expect(&random, (const double[3][2]){{-0.9, 0.1}, {-0.5, 0}, {0.5, 0}});
}

TEST(an_edge_that_is_a_point)
{
    generator random = generator_new(1);
    expect(&random, (const double[3][2]){{0.25, 0}, {0, 0.5}, {0, 0.5}});
}

TEST(on_the_edge)
{
    const double x[3][2] = {{0, 0}, {-0.5, 0}, {0.5, 0}};
    tell(x);
    double got;
    check_value(got, room(x[0], x[1], x[2]));
    check_real(0, got);
}

TEST(at_random)
{
    generator random = generator_new(2);
    for (int i = 0; i < 2000; i++) {
        double x[3][2];
        double size = i % 2 == 0 ? 1 : 1e-3;
        for (int v = 0; v < 3; v++)
            for (int k = 0; k < 2; k++)
                x[v][k] = uniform(&random, -size, size);
        if (distance_to(x[0], x[1], x[2]) >= 1e-6)
            expect(&random, (const double(*)[2])x);
    }
}

void run_tests(void)
{
    check_run(1, straight_at_each_other);
    check_run(1, beyond_an_end);
    check_run(1, an_edge_that_is_a_point);
    check_run(1, on_the_edge);
    check_run(1, at_random);
}
