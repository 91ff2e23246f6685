#include "check.h"

#include "support/support.h"
#include "surface/crossing.h"

#include <math.h>
#include <string.h>

int repair(int count, double most, double position[][2]);

enum {
    ROOM = 1000
};

/// A closed polygon.
typedef struct curve {
    int count;
    double position[ROOM][2];
} curve;

static const double pi = 3.141592653589793;

// What is asked for -----------------------------------------------------------

static double area(const curve *given)
{
    double sum = 0;
    const double *o = given->position[0];
    for (int i = 1; i + 1 < given->count; i++) {
        const double *a = given->position[i], *b = given->position[i + 1];
        sum +=
            ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])) / 2;
    }
    return sum;
}

static void expect_lengths(const curve *given, double most)
{
    int shorts = 0;
    for (int i = 0; i < given->count; i++) {
        const double *a = given->position[i],
                     *b = given->position[(i + 1) % given->count];
        double length = hypot(b[0] - a[0], b[1] - a[1]);
        check_that(length <= most * (1 + 1e-12), "no edge longer than `most`",
                   "%s from %s to %s", text_real(length), text_point(2, a),
                   text_point(2, b));
        shorts += length < most / 4;
    }
    check_that(10 * shorts <= given->count,
               "at most one edge in ten shorter than a quarter of `most`",
               "%d of %d", shorts, given->count);
}

/// Exactly.
static void expect_clear(const curve *given)
{
    int n = given->count;
    for (int i = 0; i < n; i++)
        for (int j = i + 2; j < n - (i == 0); j++) {
            const double *a = given->position[i], *b = given->position[i + 1];
            const double *c = given->position[j],
                         *d = given->position[(j + 1) % n];
            if (tf_edges_cross(a, b, c, d))
                check_that(false, "no two edges that meet",
                           "from %s to %s, and from %s to %s", text_point(2, a),
                           text_point(2, b), text_point(2, c),
                           text_point(2, d));
        }
}

static double distance(const double p[2], const double a[2], const double b[2])
{
    double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    double along = (p[0] - a[0]) * x + (p[1] - a[1]) * y;
    double t = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    return hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

/// All vertices of one are near the other.
static void expect_near(const curve *one, const curve *other, double most)
{
    for (int v = 0; v < one->count; v++) {
        double least = INFINITY;
        for (int i = 0; i < other->count; i++)
            least =
                fmin(least, distance(one->position[v], other->position[i],
                                     other->position[(i + 1) % other->count]));
        check_that(least <= most / 2, "polygons near each other",
                   "%s, farther than `most` / 2 from the other one",
                   text_point(2, one->position[v]));
    }
}

static void expect_repaired(const char *name, curve *given, double most)
{
    curve old = *given;
    check_input("%s: %d vertices, the first at %s; most = %s", name,
                given->count, text_point(2, given->position[0]),
                text_real(most));
    check_call(given->position,
               given->count = repair(given->count, most, given->position));
    check_also(given->count);
    check_that(3 <= given->count && given->count < ROOM, "3 to 999 vertices",
               "%d", given->count);
    for (int v = 0; v < given->count; v++)
        check_that(isfinite(given->position[v][0]) &&
                       isfinite(given->position[v][1]),
                   "positions", "%s", text_point(2, given->position[v]));
    expect_lengths(given, most);
    check_near(area(&old), area(given), 1e-9 * area(&old));
    expect_clear(given);
    expect_near(given, &old, most);
    expect_near(&old, given, most);
}

// Curves at rest --------------------------------------------------------------

static curve regular(int count, double x, double y, double radius)
{
    curve made = {.count = count};
    for (int v = 0; v < count; v++) {
        made.position[v][0] = x + radius * cos(2 * pi * v / count);
        made.position[v][1] = y + radius * sin(2 * pi * v / count);
    }
    return made;
}

TEST(long_edges)
{
    curve square = {4, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    expect_repaired("a square", &square, 0.3);
}

TEST(short_edges)
{
    curve circle = regular(100, 0, 0, 1);
    expect_repaired("a regular polygon", &circle, 0.3);
    curve tiny = {6, {{0, 0}, {8, 0}, {8, 8}, {4.1, 8}, {4, 8.1}, {0, 8}}};
    expect_repaired("a square with a dent", &tiny, 4);
}

// To collapse the short edge without loss would take it through the other side.
TEST(across_a_slot)
{
    curve slot = {12,
                  {{0, -1},
                   {3, -1},
                   {3, 0},
                   {1.22, 0},
                   {1.16, 0.12},
                   {1.06, 0.12},
                   {1, 0},
                   {0.5, 0},
                   {0.5, 0.15},
                   {3, 0.15},
                   {3, 1},
                   {0, 1}}};
    expect_repaired("a square with a narrow slot", &slot, 0.5);
}

// Curves that flow ------------------------------------------------------------

static void find_velocity(const double at[2], double velocity[2])
{
    velocity[0] = pow(sin(pi * at[0]), 2) * sin(2 * pi * at[1]);
    velocity[1] = -pow(sin(pi * at[1]), 2) * sin(2 * pi * at[0]);
}

static void advance(curve *given, double length)
{
    for (int v = 0; v < given->count; v++) {
        double *at = given->position[v], first[2], second[2], middle[2];
        find_velocity(at, first);
        for (int k = 0; k < 2; k++)
            middle[k] = at[k] + length / 2 * first[k];
        find_velocity(middle, second);
        for (int k = 0; k < 2; k++)
            at[k] += length * second[k];
    }
}

TEST(there_and_back_again)
{
    enum {
        STEPS = 80
    };
    const double center[2] = {0.5, 0.75};
    curve disk = regular(30, center[0], center[1], 0.15);
    for (int n = 0; n < STEPS; n++) {
        advance(&disk, n < STEPS / 2 ? 0.02 : -0.02);
        expect_repaired("a disk in a vortex", &disk, 0.04);
    }
    double squares = 0;
    for (int v = 0; v < disk.count; v++) {
        const double *at = disk.position[v];
        double radius = hypot(at[0] - center[0], at[1] - center[1]);
        squares += pow(radius / 0.15 - 1, 2);
    }
    double error = sqrt(squares / disk.count);
    check_that(error < 0.05, "a disk again, up to 5 percent", "%s percent",
               text_real(100 * error));
}

void run_tests(void)
{
    check_run(1, long_edges);
    check_run(1, short_edges);
    check_run(1, across_a_slot);
    check_run(1, there_and_back_again);
}
