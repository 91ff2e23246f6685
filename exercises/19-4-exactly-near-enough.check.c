#include "check.h"

#include "support/support.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>

bool is_nearer(const int64_t point[2], const int64_t a[2], const int64_t b[2],
               int64_t thickness);
bool keeps_rule(const int64_t start[3][2], const int64_t end[3][2],
                int64_t thickness);

typedef int64_t triple[3][2]; ///< the point and the ends of the edge

/// The least square of the point's distance from the edge, as a fraction: by the
/// one feature whose region the point is in.
static void square_of_distance(const triple x, int64_t *over, int64_t *under)
{
    int64_t along[2] = {x[2][0] - x[1][0], x[2][1] - x[1][1]};
    int64_t from[2] = {x[0][0] - x[1][0], x[0][1] - x[1][1]};
    int64_t scale = along[0] * along[0] + along[1] * along[1];
    int64_t part = along[0] * from[0] + along[1] * from[1];
    if (part > 0 && part < scale) {
        int64_t cross = along[0] * from[1] - along[1] * from[0];
        *over = cross * cross;
        *under = scale;
        return;
    }
    if (part > 0 && part >= scale)
        for (int k = 0; k < 2; k++)
            from[k] -= along[k];
    *over = from[0] * from[0] + from[1] * from[1];
    *under = 1;
}

static bool is_near(const triple x, int64_t thickness)
{
    int64_t over, under;
    square_of_distance(x, &over, &under);
    return over < thickness * thickness * under;
}

static void list(char text[160], const triple x)
{
    snprintf(text, 160,
             "(%" PRId64 ", %" PRId64 "), (%" PRId64 ", %" PRId64 ")"
             ", (%" PRId64 ", %" PRId64 ")",
             x[0][0], x[0][1], x[1][0], x[1][1], x[2][0], x[2][1]);
}

static void expect_near(bool expected, const triple x, int64_t thickness)
{
    char text[160];
    list(text, x);
    check_input("point, a, b = %s\nthickness = %" PRId64, text, thickness);
    bool got;
    check_value(got, is_nearer(x[0], x[1], x[2], thickness));
    check_that(got == expected, expected ? "nearer" : "not nearer", "%s",
               got ? "nearer" : "not nearer");
}

static void expect_rule(bool expected, const triple start, const triple end,
                        int64_t thickness)
{
    char from[160], to[160];
    list(from, start);
    list(to, end);
    check_input("start: point, a, b = %s\nend: point, a, b = %s\n"
                "thickness = %" PRId64,
                from, to, thickness);
    bool got;
    check_value(got, keeps_rule(start, end, thickness));
    check_that(got == expected,
               expected ? "the rule is kept" : "the rule is broken", "%s",
               got ? "the rule is kept" : "the rule is broken");
}

TEST(beside_the_edge)
{
    const triple x = {{3, 5}, {0, 0}, {10, 0}};
    expect_near(true, x, 6);
    expect_near(false, x, 5);
    expect_near(false, x, 4);
}

TEST(beyond_the_ends)
{
    for (int side = 0; side < 2; side++) {
        triple x = {{-3, 4}, {0, 0}, {10, 0}};
        if (side == 1)
            x[0][0] = 13;
        expect_near(false, x, 5);
        expect_near(true, x, 6);
    }
    expect_near(false, (triple){{20, 0}, {0, 0}, {10, 0}}, 10);
}

TEST(an_edge_that_is_a_point)
{
    const triple x = {{3, 4}, {0, 0}, {0, 0}};
    expect_near(false, x, 5);
    expect_near(true, x, 6);
}

/// A point beside an edge of the length root (n^2 + 1): their cross product is
/// 2 n^2 + 1, and the square of their distance is 4 n^2 + 1 / (n^2 + 1).
static void make_close_call(int64_t n, triple x)
{
    const int64_t a[2] = {-5000, -9950};
    const int64_t from[3][2] = {{-1, 2 * n}, {0, 0}, {n, 1}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            x[i][k] = a[k] + from[i][k];
}

TEST(closer_than_doubles_can_tell)
{
    for (int64_t n = 9950; n > 9750; n--) {
        triple x;
        make_close_call(n, x);
        expect_near(false, x, 2 * n);
        expect_near(true, x, 2 * n + 1);
    }
}

/// Points beside a slanted edge, at its distance 5 n.
TEST(exactly_at_a_distance)
{
    for (int64_t n = 1; n < 1000; n += 7) {
        const int64_t foot[2] = {3 * (n % 97 + 1), 4 * (n % 97 + 1)};
        const triple x = {
            {foot[0] - 4 * n, foot[1] + 3 * n}, {0, 0}, {3 * 98, 4 * 98}};
        expect_near(false, x, 5 * n);
        expect_near(true, x, 5 * n + 1);
    }
}

TEST(the_rule_about_the_start)
{
    const triple near = {{3, 4}, {0, 0}, {10, 0}};
    const triple limit = {{3, 5}, {0, 0}, {10, 0}};
    const triple far = {{3, 9}, {0, 0}, {10, 0}};
    expect_rule(true, near, near, 5);
    expect_rule(true, near, far, 5);
    expect_rule(true, far, far, 5);
    expect_rule(true, far, limit, 5);
    expect_rule(false, far, near, 5);
    expect_rule(false, limit, near, 5);
}

static void draw_at_random(generator *random, int most, triple x)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            x[i][k] = (int64_t)uniform(random, -most, most + 1);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 4000; i++) {
        int most = i % 2 == 0 ? 6 : 10000;
        triple start, end;
        draw_at_random(&random, most, start);
        draw_at_random(&random, most, end);
        int64_t thickness = 1 + (int64_t)uniform(&random, 0, most);
        bool before = is_near(start, thickness);
        bool after = is_near(end, thickness);
        expect_near(before, start, thickness);
        expect_near(after, end, thickness);
        expect_rule(before || !after, start, end, thickness);
    }
}

void run_tests(void)
{
    check_run(1, beside_the_edge);
    check_run(1, beyond_the_ends);
    check_run(1, an_edge_that_is_a_point);
    check_run(1, closer_than_doubles_can_tell);
    check_run(1, exactly_at_a_distance);
    check_run(1, the_rule_about_the_start);
    check_run(1, at_random);
}
