#include "check.h"

#include "support/support.h"

#include <math.h>

enum {
    MOST = 8
};

void collapse_position(int count, const double ring[][3], const double s[3],
                       const double d[3], double before, double position[3]);

typedef struct hole {
    int count, half; ///< s sees the ring from 0 to half, d the rest
    double ring[MOST][3], s[3], d[3];
} hole;

static double determinant(const double a[3], const double b[3],
                          const double c[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] -
                       b[(k + 2) % 3] * c[(k + 1) % 3]);
    return sum;
}

/// The ring from one of its vertices to another, joined to a vertex.
static double fan(const hole *given, const double vertex[3], int from, int to)
{
    double sum = 0;
    for (int i = from; i < to; i++)
        sum += determinant(vertex, given->ring[i % given->count],
                           given->ring[(i + 1) % given->count]);
    return sum;
}

static double before(const hole *given)
{
    return fan(given, given->s, 0, given->half) +
           fan(given, given->d, given->half, given->count) +
           determinant(given->s, given->ring[given->half], given->d) +
           determinant(given->d, given->ring[0], given->s);
}

static void expect_kept(const hole *given)
{
    double position[3] = {NAN, NAN, NAN}, area[3], shift[3];
    check_input("s = %s, d = %s, a ring of %d, the first at %s; before = %.17g",
                text_point(3, given->s), text_point(3, given->d), given->count,
                text_point(3, given->ring[0]), before(given));
    check_call(position,
               collapse_position(given->count, (const double(*)[3])given->ring,
                                 given->s, given->d, before(given), position));
    check_near(before(given), fan(given, position, 0, given->count), 1e-11);
    double squares = 0, square = 0, along = 0;
    for (int k = 0; k < 3; k++) {
        double unit[3] = {k == 0, k == 1, k == 2};
        area[k] = fan(given, unit, 0, given->count);
        shift[k] = position[k] - (given->s[k] + given->d[k]) / 2;
        squares += area[k] * area[k];
        square += shift[k] * shift[k];
        along += area[k] * shift[k];
    }
    check_near(sqrt(squares * square), fabs(along), 1e-6);
}

// A flat ring below a short ridge.
static const hole roof = {
    .count = 4,
    .half = 2,
    .ring = {{0, -2, 0}, {2, 0, 0}, {0, 2, 0}, {-2, 0, 0}},
    .s = {0.5, 0, 1},
    .d = {-0.5, 0, 1}};

TEST(a_ridge_becomes_a_peak)
{
    double position[3] = {NAN, NAN, NAN};
    check_input("s = %s, d = %s, a square ring", text_point(3, roof.s),
                text_point(3, roof.d));
    check_call(position, collapse_position(4, roof.ring, roof.s, roof.d,
                                           before(&roof), position));
    // The ridge has a quarter more than the pyramid of the same height.
    check_near(0, position[0], 1e-14);
    check_near(0, position[1], 1e-14);
    check_near(before(&roof) / 16, position[2], 1e-14);
    expect_kept(&roof);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        hole given = {.count = 4 + below(&random, MOST - 3)};
        given.half = given.count / 2;
        for (int v = 0; v < given.count; v++) {
            double turn = 2 * acos(-1) * v / given.count;
            given.ring[v][0] = cos(turn) + uniform(&random, -0.2, 0.2);
            given.ring[v][1] = 2 + sin(turn) + uniform(&random, -0.2, 0.2);
            given.ring[v][2] = uniform(&random, -0.5, 0.5);
        }
        for (int k = 0; k < 3; k++) {
            given.s[k] = uniform(&random, -1, 1);
            given.d[k] = uniform(&random, -1, 1);
        }
        expect_kept(&given);
    }
}

void run_tests(void)
{
    check_run(1, a_ridge_becomes_a_peak);
    check_run(1, at_random);
}
