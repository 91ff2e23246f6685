#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

enum {
    MOST = 8
};

void put_apex(int count, const double triangle[][3][3], const double wanted[3],
              double gain, double position[3]);

/// A fan of triangles between a ring and a vertex, as it is before.
typedef struct fan {
    int count;
    double ring[MOST][3], middle[3], wanted[3], gain;
} fan;

static double determinant(const double a[3], const double b[3],
                          const double c[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] -
                       b[(k + 2) % 3] * c[(k + 1) % 3]);
    return sum;
}

/// The volume between the ring with an apex and the origin.
static double volume(const fan *given, const double apex[3])
{
    double sum = 0;
    for (int i = 0; i < given->count; i++)
        sum += determinant(apex, given->ring[i],
                           given->ring[(i + 1) % given->count]);
    return sum / 6;
}

static void find(const fan *given, double position[3])
{
    double triangle[MOST][3][3];
    for (int i = 0; i < given->count; i++) {
        memcpy(triangle[i][0], given->middle, sizeof given->middle);
        memcpy(triangle[i][1], given->ring[i], sizeof given->ring[i]);
        memcpy(triangle[i][2], given->ring[(i + 1) % given->count],
               sizeof given->ring[i]);
    }
    for (int k = 0; k < 3; k++)
        position[k] = NAN;
    check_input("a fan of %d triangles around %s; wanted %s, gain = %.17g",
                given->count, text_point(3, given->middle),
                text_point(3, given->wanted), given->gain);
    check_call_n(3, position,
                 put_apex(given->count, (const double(*)[3][3])triangle,
                          given->wanted, given->gain, position));
}

/// The volume must be right, and the way along the slope of the volume.
static void expect_position(const fan *given)
{
    double position[3], slope[3], way[3];
    find(given, position);
    check_near(volume(given, given->middle) + given->gain,
               volume(given, position), 1e-11);
    double slopes = 0, ways = 0, both = 0;
    for (int k = 0; k < 3; k++) {
        double unit[3] = {k == 0, k == 1, k == 2};
        slope[k] = volume(given, unit);
        way[k] = position[k] - given->wanted[k];
        slopes += slope[k] * slope[k];
        ways += way[k] * way[k];
        both += slope[k] * way[k];
    }
    check_near(sqrt(slopes * ways), fabs(both), 1e-6);
}

static const fan pyramid = {
    .count = 4,
    .ring = {{1, 0, 2}, {0, 1, 2}, {-1, 0, 2}, {0, -1, 2}},
    .middle = {0, 0, 3},
    .wanted = {0.25, -0.5, 2}};

TEST(a_pyramid_keeps_its_height)
{
    double position[3];
    find(&pyramid, position);
    check_near(0.25, position[0], 1e-14);
    check_near(-0.5, position[1], 1e-14);
    check_near(3, position[2], 1e-14);
}

// The base has the area 2.
TEST(a_pyramid_grows)
{
    fan grown = pyramid;
    grown.gain = 1;
    double position[3];
    find(&grown, position);
    check_near(4.5, position[2], 1e-14);
    expect_position(&grown);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        fan given = {.count = 3 + below(&random, MOST - 2)};
        for (int v = 0; v < given.count; v++) {
            double turn = 2 * acos(-1) * v / given.count;
            given.ring[v][0] = 3 + cos(turn) + uniform(&random, -0.2, 0.2);
            given.ring[v][1] = sin(turn) + uniform(&random, -0.2, 0.2);
            given.ring[v][2] = uniform(&random, -0.5, 0.5);
        }
        for (int k = 0; k < 3; k++) {
            given.middle[k] = uniform(&random, -1, 1);
            given.wanted[k] = uniform(&random, -1, 1);
        }
        given.gain = i % 3 == 0 ? 0 : uniform(&random, -1, 1);
        expect_position(&given);
    }
}

void run_tests(void)
{
    check_run(1, a_pyramid_keeps_its_height);
    check_run(1, a_pyramid_grows);
    check_run(1, at_random);
}
