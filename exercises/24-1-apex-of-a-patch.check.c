#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

enum {
    MOST = 8
};

void place_apex(int count, const double triangle[][3][3],
                const double wanted[3], double gain, double place[3]);

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
static double volume(const fan *of, const double apex[3])
{
    double sum = 0;
    for (int i = 0; i < of->count; i++)
        sum += determinant(apex, of->ring[i], of->ring[(i + 1) % of->count]);
    return sum / 6;
}

static void find(const fan *of, double place[3])
{
    double triangle[MOST][3][3];
    for (int i = 0; i < of->count; i++) {
        memcpy(triangle[i][0], of->middle, sizeof of->middle);
        memcpy(triangle[i][1], of->ring[i], sizeof of->ring[i]);
        memcpy(triangle[i][2], of->ring[(i + 1) % of->count],
               sizeof of->ring[i]);
    }
    for (int k = 0; k < 3; k++)
        place[k] = NAN;
    check_input("a fan of %d triangles around %s; wanted %s, gain = %.17g",
                of->count, text_point(3, of->middle), text_point(3, of->wanted),
                of->gain);
    check_call_n(3, place,
                 place_apex(of->count, (const double(*)[3][3])triangle,
                            of->wanted, of->gain, place));
}

/// The volume must be right, and the way along the slope of the volume.
static void expect_place(const fan *of)
{
    double place[3], slope[3], way[3];
    find(of, place);
    check_near(volume(of, of->middle) + of->gain, volume(of, place), 1e-11);
    double slopes = 0, ways = 0, both = 0;
    for (int k = 0; k < 3; k++) {
        double unit[3] = {k == 0, k == 1, k == 2};
        slope[k] = volume(of, unit);
        way[k] = place[k] - of->wanted[k];
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
    double place[3];
    find(&pyramid, place);
    check_near(0.25, place[0], 1e-14);
    check_near(-0.5, place[1], 1e-14);
    check_near(3, place[2], 1e-14);
}

// The base has the area 2.
TEST(a_pyramid_grows)
{
    fan grown = pyramid;
    grown.gain = 1;
    double place[3];
    find(&grown, place);
    check_near(4.5, place[2], 1e-14);
    expect_place(&grown);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        fan of = {.count = 3 + below(&random, MOST - 2)};
        for (int v = 0; v < of.count; v++) {
            double turn = 2 * acos(-1) * v / of.count;
            of.ring[v][0] = 3 + cos(turn) + uniform(&random, -0.2, 0.2);
            of.ring[v][1] = sin(turn) + uniform(&random, -0.2, 0.2);
            of.ring[v][2] = uniform(&random, -0.5, 0.5);
        }
        for (int k = 0; k < 3; k++) {
            of.middle[k] = uniform(&random, -1, 1);
            of.wanted[k] = uniform(&random, -1, 1);
        }
        of.gain = i % 3 == 0 ? 0 : uniform(&random, -1, 1);
        expect_place(&of);
    }
}

void run_tests(void)
{
    check_run(1, a_pyramid_keeps_its_height);
    check_run(1, a_pyramid_grows);
    check_run(1, at_random);
}
