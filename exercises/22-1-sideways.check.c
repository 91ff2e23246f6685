#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

enum {
    MOST = 8
};

void move_sideways(int count, const double ring[][3], const double from[3],
                   const double wanted[3], double place[3]);

typedef struct star {
    int count;
    double ring[MOST][3], from[3], wanted[3];
} star;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Six times the volume between the star of a vertex and the origin.
static double six_volumes(const star *of, const double vertex[3])
{
    double sum = 0;
    for (int i = 0; i < of->count; i++) {
        const double *a = of->ring[i], *b = of->ring[(i + 1) % of->count];
        for (int k = 0; k < 3; k++)
            sum += vertex[k] * (a[(k + 1) % 3] * b[(k + 2) % 3] -
                                a[(k + 2) % 3] * b[(k + 1) % 3]);
    }
    return sum;
}

static void find(const star *of, double place[3])
{
    for (int k = 0; k < 3; k++)
        place[k] = NAN;
    check_input("a ring of %d, the first at %s; from %s, wanted %s", of->count,
                text_point(3, of->ring[0]), text_point(3, of->from),
                text_point(3, of->wanted));
    check_call_n(3, place,
                 move_sideways(of->count, (const double(*)[3])of->ring,
                               of->from, of->wanted, place));
}

/// The volume must be as before, and the way from the place to what is wanted
/// must be along the vector area: perpendicular to all other directions.
static void expect_sideways(const star *of)
{
    double place[3], unit[3], slope[3], rest[3];
    find(of, place);
    check_near(six_volumes(of, of->from), six_volumes(of, place), 1e-11);
    for (int k = 0; k < 3; k++) {
        memset(unit, 0, sizeof unit);
        unit[k] = 1;
        slope[k] = six_volumes(of, unit);
        rest[k] = of->wanted[k] - place[k];
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
    double place[3];
    find(&flat, place);
    check_near(0.25, place[0], 1e-14);
    check_near(-0.5, place[1], 1e-14);
    check_near(3, place[2], 1e-14);
}

TEST(at_rest)
{
    star still = flat;
    memcpy(still.wanted, still.from, sizeof still.from);
    double place[3];
    find(&still, place);
    for (int k = 0; k < 3; k++)
        check_near(still.from[k], place[k], 1e-14);
}

// There and back again: the ring has no area.
TEST(no_area)
{
    star folded = {.count = 4,
                   .ring = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}},
                   .from = {1, 1, 0},
                   .wanted = {1, 0.5, 0.25}};
    double place[3];
    find(&folded, place);
    for (int k = 0; k < 3; k++)
        check_near(folded.wanted[k], place[k], 1e-14);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        star of = {.count = 3 + below(&random, MOST - 2)};
        for (int v = 0; v < of.count; v++) {
            double turn = 2 * acos(-1) * v / of.count;
            of.ring[v][0] = 3 + cos(turn) + uniform(&random, -0.2, 0.2);
            of.ring[v][1] = sin(turn) + uniform(&random, -0.2, 0.2);
            of.ring[v][2] = uniform(&random, -0.5, 0.5);
        }
        for (int k = 0; k < 3; k++) {
            of.from[k] = uniform(&random, -1, 1);
            of.wanted[k] = uniform(&random, -1, 1);
        }
        expect_sideways(&of);
    }
}

void run_tests(void)
{
    check_run(1, a_flat_ring);
    check_run(1, at_rest);
    check_run(1, no_area);
    check_run(1, at_random);
}
