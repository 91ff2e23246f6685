#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>

int move_apart(int first, const double a[][2], int second, const double b[][2],
               int directions, const double direction[][2], double move[2]);

enum {
    MOST = 8 ///< corners of a polygon, and directions
};

/// Two polygons, and directions.
typedef struct scene {
    int first, second, directions;
    double a[MOST][2], b[MOST][2], direction[MOST][2];
} scene;

static void list(char text[800], int count, const double x[][2])
{
    char *at = text;
    for (int i = 0; i < count; i++)
        at += sprintf(at, "%s(%.17g, %.17g)", i ? ", " : "", x[i][0], x[i][1]);
}

static int ask(const scene *s, double move[2])
{
    char a[800], b[800], direction[800];
    list(a, s->first, s->a);
    list(b, s->second, s->b);
    list(direction, s->directions, s->direction);
    check_input("first: %s\nsecond: %s\ndirections: %s", a, b, direction);
    int got;
    move[0] = move[1] = NAN;
    check_value(got, move_apart(s->first, s->a, s->second, s->b, s->directions,
                                s->direction, move));
    check_take(move, 2 * sizeof *move);
    return got;
}

static void expect(int index, double x, double y, const scene *s)
{
    double move[2];
    char right[16];
    int got = ask(s, move);
    snprintf(right, sizeof right, "%d", index);
    check_that(got == index, right, "%d", got);
    check_point(2, ((const double[]){x, y}), move, 1e-14);
}

static double turn(const double u[2], const double v[2])
{
    return u[0] * v[1] - u[1] * v[0];
}

/// How many times a direction leads out of all differences of a point of b and
/// one of a: the farthest that a line from difference to difference crosses it.
static double farthest(const scene *s, const double direction[2])
{
    double most = 0;
    int count = s->first * s->second;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            double p[2], along[2];
            for (int k = 0; k < 2; k++) {
                p[k] = s->b[i / s->first][k] - s->a[i % s->first][k];
                along[k] = s->b[j / s->first][k] - s->a[j % s->first][k] - p[k];
            }
            double across = turn(direction, along);
            if (across != 0 && turn(p, direction) / across >= 0 &&
                turn(p, direction) / across <= 1)
                most = fmax(most, turn(p, along) / across);
        }
    return most;
}

static const scene squares = {
    .first = 4,
    .second = 4,
    .directions = 4,
    .a = {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
    .b = {{3, -1}, {9, -1}, {9, 5}, {3, 5}},
    .direction = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}},
};

TEST(two_squares)
{
    expect(2, -1, 0, &squares);
    scene s = squares;
    for (int i = 0; i < 4; i++) {
        s.b[i][0] -= 2;
        s.b[i][1] += 3;
    }
    expect(3, 0, -2, &s);
}

TEST(long_directions)
{
    scene s = squares;
    s.direction[2][0] = -0.25;
    s.direction[3][1] = -100;
    expect(2, -1, 0, &s);
}

TEST(equally_far)
{
    scene s = squares;
    for (int i = 0; i < 4; i++)
        s.b[i][1] += 4;
    expect(2, -1, 0, &s);
}

TEST(a_slanting_edge)
{
    const scene s = {
        .first = 3,
        .second = 4,
        .directions = 4,
        .a = {{3, 0}, {0, 3}, {-3, 0}},
        .b = {{1, 1}, {5, 1}, {5, 5}, {1, 5}},
        .direction = {{1, 0}, {0, -1}, {-1, -1}, {-1, 1}},
    };
    expect(2, -0.5, -0.5, &s);
}

TEST(a_square_in_a_triangle)
{
    const scene s = {
        .first = 4,
        .second = 3,
        .directions = 3,
        .a = {{2, 2}, {3, 2}, {3, 3}, {2, 3}},
        .b = {{0, 0}, {12, 0}, {0, 12}},
        .direction = {{1, 1}, {-1, -2}, {0, 5}},
    };
    expect(1, -1.5, -3, &s);
}

/// Corners around a circle: at least three, and on all sides of its center.
static int add_corners(generator *random, double x, double y, double r,
                       double corner[MOST][2])
{
    int corners = 3 + below(random, MOST - 2);
    double start = uniform(random, 0, 6);
    for (int i = 0; i < corners; i++) {
        double angle = start + (i + uniform(random, 0, 0.4)) * 6.28 / corners;
        corner[i][0] = x + r * cos(angle);
        corner[i][1] = y + r * sin(angle);
    }
    return corners;
}

TEST(some_at_random)
{
    generator random = generator_new(21);
    for (int times = 0; times < 400; times++) {
        scene s = {.directions = 1 + below(&random, MOST)};
        s.first = add_corners(&random, 0, 0, uniform(&random, 1, 2), s.a);
        s.second = add_corners(&random, uniform(&random, -0.3, 0.3),
                               uniform(&random, -0.3, 0.3),
                               uniform(&random, 1, 3), s.b);
        double shortest = INFINITY, move[2];
        for (int i = 0; i < s.directions; i++) {
            double angle = uniform(&random, 0, 6.3);
            double length = uniform(&random, 0.1, 3);
            s.direction[i][0] = length * cos(angle);
            s.direction[i][1] = length * sin(angle);
            shortest = fmin(shortest, length * farthest(&s, s.direction[i]));
        }
        int got = ask(&s, move);
        check_that(got >= 0 && got < s.directions, "the index of a direction",
                   "%d", got);
        check_near(shortest, hypot(move[0], move[1]), 1e-9);
        check_near(0, turn(move, s.direction[got]), 1e-9);
        check_near(
            1, farthest(&s, s.direction[got]) * s.direction[got][0] / move[0],
            1e-6);
    }
}

void run_tests(void)
{
    check_run(1, two_squares);
    check_run(1, long_directions);
    check_run(1, equally_far);
    check_run(1, a_slanting_edge);
    check_run(1, a_square_in_a_triangle);
    check_run(1, some_at_random);
}
