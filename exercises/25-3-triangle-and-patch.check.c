#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

double volume_under(const double corner[][3], const double middle[][3]);

typedef struct patch {
    double corner[3][3], middle[3][3];
} patch;

/// Moves the middles of the sides from where they are, by a vector each.
static void lift(patch *given, const double rise[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            given->middle[i][k] =
                (given->corner[i][k] + given->corner[(i + 1) % 3][k]) / 2 +
                rise[i][k];
}

static double find(const patch *given)
{
    check_input(
        "corners %s, %s, %s; middles %s, %s, %s",
        text_point(3, given->corner[0]), text_point(3, given->corner[1]),
        text_point(3, given->corner[2]), text_point(3, given->middle[0]),
        text_point(3, given->middle[1]), text_point(3, given->middle[2]));
    double got;
    check_value(got, volume_under(given->corner, given->middle));
    return got;
}

static const patch right = {.corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

// The mean height of x (1 - x - y) * 4 is 1/3, and the area 1/2.
TEST(one_side_rises)
{
    patch given = right;
    lift(&given, (const double[3][3]){{0, 0, 1}});
    check_near(1.0 / 6, find(&given), 1e-15);
}

TEST(each_side_rises)
{
    patch given = right;
    lift(&given, (const double[3][3]){{0, 0, 3}, {0, 0, -1}, {0, 0, 4}});
    check_near(1, find(&given), 1e-15);
}

TEST(sideways_loses_nothing)
{
    patch given = right;
    lift(&given, (const double[3][3]){{1, 2, 0}, {-3, 1, 0}, {0.5, 0, 0}});
    check_near(0, find(&given), 1e-15);
}

/// A point of the patch, by its coordinates.
static void point_of(const patch *given, const double weight[3], double at[3])
{
    for (int k = 0; k < 3; k++) {
        at[k] = 0;
        for (int i = 0; i < 3; i++) {
            double own = weight[i], next = weight[(i + 1) % 3];
            at[k] += own * (2 * own - 1) * given->corner[i][k] +
                     4 * own * next * given->middle[i][k];
        }
    }
}

static double determinant(const double a[3], const double b[3],
                          const double c[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] -
                       b[(k + 2) % 3] * c[(k + 1) % 3]);
    return sum;
}

/// The volume of a small triangle of the patch with the origin.
static double piece(const patch *given, int n, const int part[3][2])
{
    double at[3][3];
    for (int i = 0; i < 3; i++) {
        double a = part[i][0] / (double)n, b = part[i][1] / (double)n;
        point_of(given, (const double[]){1 - a - b, a, b}, at[i]);
    }
    return determinant(at[0], at[1], at[2]) / 6;
}

/// The volume between the patch, in small triangles, and the origin.
static double volume(const patch *given, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n - i; j++) {
            sum += piece(given, n,
                         (const int[3][2]){{i, j}, {i + 1, j}, {i, j + 1}});
            if (i + j + 2 <= n)
                sum += piece(
                    given, n,
                    (const int[3][2]){{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        }
    return sum;
}

/// Its sides stay in the planes through their ends and the origin, so that what
/// it has more volume with the origin than the triangle is between the two.
static patch random_patch(generator *random, double size)
{
    patch given = {.corner = {{0}}};
    double rise[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            given.corner[i][k] = (k == i ? 1 : 0) + uniform(random, -0.2, 0.2);
    for (int i = 0; i < 3; i++) {
        double far = uniform(random, -size, size);
        for (int k = 0; k < 3; k++)
            rise[i][k] =
                far * (given.corner[i][k] + given.corner[(i + 1) % 3][k]);
    }
    lift(&given, rise);
    return given;
}

// The pieces are 1/30 of the triangle long, so their volume is short of that of
// the patch by about 1/900 of what is lost.
TEST(small_rises)
{
    generator random = generator_new(0);
    for (int i = 0; i < 100; i++) {
        patch given = random_patch(&random, 1e-3);
        double expected = volume(&given, 30) - volume(&given, 1);
        check_near(expected, find(&given), 3e-5);
    }
}

void run_tests(void)
{
    check_run(1, one_side_rises);
    check_run(1, each_side_rises);
    check_run(1, sideways_loses_nothing);
    check_run(1, small_rises);
}
