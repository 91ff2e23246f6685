#include "check.h"

#include "support/support.h"

#include <stdio.h>

typedef struct place {
    long long x, y;
} place;

typedef struct common {
    long long s, s1, s2, r, r1, r2;
} common;

common before_the_end(place s, place s1, place s2, place r, place r1, place r2);

static long long turn(place a, place b, place c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two places are strictly on different sides of a line.
static bool parts(place a, place b, place first, place second)
{
    long long u = turn(a, b, first), v = turn(a, b, second);
    return (u < 0 && v > 0) || (u > 0 && v < 0);
}

/// The sum of three places, each multiplied by its coordinate.
static place sum(long long a, place of_a, long long b, place of_b, long long c,
                 place of_c)
{
    return (place){a * of_a.x + b * of_b.x + c * of_c.x,
                   a * of_a.y + b * of_b.y + c * of_c.y};
}

static void expect(const place p[6])
{
    check_input("S = {(%lld, %lld) | (%lld, %lld), (%lld, %lld)}\n"
                "R = {(%lld, %lld) | (%lld, %lld), (%lld, %lld)}",
                p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y,
                p[4].x, p[4].y, p[5].x, p[5].y);
    common c;
    check_value(c, before_the_end(p[0], p[1], p[2], p[3], p[4], p[5]));
    char got[160];
    snprintf(got, sizeof got, "%lld, %lld, %lld and %lld, %lld, %lld", c.s,
             c.s1, c.s2, c.r, c.r1, c.r2);
    check_that(c.s >= 0 && c.s1 >= 0 && c.s2 >= 0 && c.r >= 0 && c.r1 >= 0 &&
                   c.r2 >= 0,
               "coordinates that are not negative", "%s", got);
    check_that(c.s > 0, "a time before 1, so a coordinate of s above 0", "%s",
               got);
    check_that(c.s == c.r && c.s1 + c.s2 == c.r1 + c.r2,
               "the same time for S and R: the same sum over the start events, "
               "and over the end events",
               "%s", got);
    place a = sum(c.s, p[0], c.s1, p[1], c.s2, p[2]);
    place b = sum(c.r, p[3], c.r1, p[4], c.r2, p[5]);
    check_that(a.x == b.x && a.y == b.y, "one place",
               "(%lld, %lld) and "
               "(%lld, %lld), from %s",
               a.x, a.y, b.x, b.y, got);
}

TEST(the_example_of_the_chapter)
{
    expect((const place[6]){{-2, 3}, {0, 0}, {4, 0}, {4, 1}, {2, -2}, {2, 2}});
}

TEST(edges_anywhere)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500;) {
        place p[6];
        for (int j = 0; j < 6; j++)
            p[j] = (place){below(&random, 41) - 20, below(&random, 41) - 20};
        if (!parts(p[1], p[2], p[4], p[5]) || !parts(p[4], p[5], p[1], p[2]))
            continue;
        expect(p);
        i++;
    }
}

void run_tests(void)
{
    check_run(1, the_example_of_the_chapter);
    check_run(1, edges_anywhere);
}
