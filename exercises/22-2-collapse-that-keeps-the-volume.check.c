#include "check.h"

#include "support/support.h"

#include <math.h>

enum {
    MOST = 8
};

void place_that_keeps(int count, const double ring[][3], const double s[3],
                      const double d[3], double before, double place[3]);

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
static double fan(const hole *of, const double vertex[3], int from, int to)
{
    double sum = 0;
    for (int i = from; i < to; i++)
        sum += determinant(vertex, of->ring[i % of->count],
                           of->ring[(i + 1) % of->count]);
    return sum;
}

static double before(const hole *of)
{
    return fan(of, of->s, 0, of->half) + fan(of, of->d, of->half, of->count) +
           determinant(of->s, of->ring[of->half], of->d) +
           determinant(of->d, of->ring[0], of->s);
}

static void expect_kept(const hole *of)
{
    double place[3] = {NAN, NAN, NAN}, area[3], shift[3];
    check_input("s = %s, d = %s, a ring of %d, the first at %s; before = %.17g",
                text_point(3, of->s), text_point(3, of->d), of->count,
                text_point(3, of->ring[0]), before(of));
    check_call(place, place_that_keeps(of->count, (const double(*)[3])of->ring,
                                       of->s, of->d, before(of), place));
    check_near(before(of), fan(of, place, 0, of->count), 1e-11);
    double squares = 0, square = 0, along = 0;
    for (int k = 0; k < 3; k++) {
        double unit[3] = {k == 0, k == 1, k == 2};
        area[k] = fan(of, unit, 0, of->count);
        shift[k] = place[k] - (of->s[k] + of->d[k]) / 2;
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
    double place[3] = {NAN, NAN, NAN};
    check_input("s = %s, d = %s, a square ring", text_point(3, roof.s),
                text_point(3, roof.d));
    check_call(place, place_that_keeps(4, roof.ring, roof.s, roof.d,
                                       before(&roof), place));
    // The ridge has a quarter more than the pyramid of the same height.
    check_near(0, place[0], 1e-14);
    check_near(0, place[1], 1e-14);
    check_near(before(&roof) / 16, place[2], 1e-14);
    expect_kept(&roof);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        hole of = {.count = 4 + below(&random, MOST - 3)};
        of.half = of.count / 2;
        for (int v = 0; v < of.count; v++) {
            double turn = 2 * acos(-1) * v / of.count;
            of.ring[v][0] = cos(turn) + uniform(&random, -0.2, 0.2);
            of.ring[v][1] = 2 + sin(turn) + uniform(&random, -0.2, 0.2);
            of.ring[v][2] = uniform(&random, -0.5, 0.5);
        }
        for (int k = 0; k < 3; k++) {
            of.s[k] = uniform(&random, -1, 1);
            of.d[k] = uniform(&random, -1, 1);
        }
        expect_kept(&of);
    }
}

void run_tests(void)
{
    check_run(1, a_ridge_becomes_a_peak);
    check_run(1, at_random);
}
