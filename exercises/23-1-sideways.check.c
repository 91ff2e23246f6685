#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

enum {
    MOST = 8
};

void move_sideways(int count, const double ring[][3], const double from[3],
                   const double wanted[3], double position[3]);

typedef struct star {
    int count;
    double ring[MOST][3], from[3], wanted[3];
} star;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Six times the volume between the star of a vertex and the origin.
static double six_volumes(const star *given, const double vertex[3])
{
    double sum = 0;
    for (int i = 0; i < given->count; i++) {
        const double *a = given->ring[i],
                     *b = given->ring[(i + 1) % given->count];
        for (int k = 0; k < 3; k++)
            sum += vertex[k] * (a[(k + 1) % 3] * b[(k + 2) % 3] -
                                a[(k + 2) % 3] * b[(k + 1) % 3]);
    }
    return sum;
}

static void find(const star *given, double position[3])
{
    for (int k = 0; k < 3; k++)
        position[k] = NAN;
    check_input("a ring of %d, the first at %s; from %s, wanted %s",
                given->count, text_point(3, given->ring[0]),
                text_point(3, given->from), text_point(3, given->wanted));
    check_call_n(3, position,
                 move_sideways(given->count, (const double(*)[3])given->ring,
                               given->from, given->wanted, position));
}

/// The volume must be as before, and the way from there to what is wanted
/// must be along the vector area: perpendicular to all other directions.
static void expect_sideways(const star *given)
{
    double position[3], unit[3], slope[3], rest[3];
    find(given, position);
    check_near(six_volumes(given, given->from), six_volumes(given, position),
               1e-11);
    for (int k = 0; k < 3; k++) {
        memset(unit, 0, sizeof unit);
        unit[k] = 1;
        slope[k] = six_volumes(given, unit);
        rest[k] = given->wanted[k] - position[k];
    }
    double square = dot(rest, rest) * dot(slope, slope);
    check_near(sqrt(square), fabs(dot(rest, slope)), 1e-6);
}

static const star flat = {
    .count = 4,
    .ring = {{1, 0, 2}, {0, 1, 2}, {-1, 0, 2}, {0, -1, 2}},
    .from = {0, 0, 3},
    .wanted = {0.25, -0.5, 2}};

TEST(a_flat_ring)
{
    double position[3];
    find(&flat, position);
    check_near(0.25, position[0], 1e-14);
    check_near(-0.5, position[1], 1e-14);
    check_near(3, position[2], 1e-14);
}

TEST(at_rest)
{
    star still = flat;
    memcpy(still.wanted, still.from, sizeof still.from);
    double position[3];
    find(&still, position);
    for (int k = 0; k < 3; k++)
        check_near(still.from[k], position[k], 1e-14);
}

// There and back again: the ring has no area.
TEST(no_area)
{
    star folded = {.count = 4,
                   .ring = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}},
                   .from = {1, 1, 0},
                   .wanted = {1, 0.5, 0.25}};
    double position[3];
    find(&folded, position);
    for (int k = 0; k < 3; k++)
        check_near(folded.wanted[k], position[k], 1e-14);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        star given = {.count = 3 + below(&random, MOST - 2)};
        for (int v = 0; v < given.count; v++) {
            double turn = 2 * acos(-1) * v / given.count;
            given.ring[v][0] = 3 + cos(turn) + uniform(&random, -0.2, 0.2);
            given.ring[v][1] = sin(turn) + uniform(&random, -0.2, 0.2);
            given.ring[v][2] = uniform(&random, -0.5, 0.5);
        }
        for (int k = 0; k < 3; k++) {
            given.from[k] = uniform(&random, -1, 1);
            given.wanted[k] = uniform(&random, -1, 1);
        }
        expect_sideways(&given);
    }
}

void run_tests(void)
{
    check_run(1, a_flat_ring);
    check_run(1, at_rest);
    check_run(1, no_area);
    check_run(1, at_random);
}
