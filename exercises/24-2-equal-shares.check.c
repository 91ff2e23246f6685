#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

enum {
    VERTICES = 6,
    SIDES = 8
};

void normal_of(int vertex, double normal[3]);
double give_back(int count, const int vertex[], double debt, double most,
                 double position[][3]);

/// An octahedron; the axis of a vertex is half its number.
static const int side[SIDES][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                   {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
static double at[VERTICES][3];

static void reset(void)
{
    memset(at, 0, sizeof at);
    for (int v = 0; v < VERTICES; v++)
        at[v][v / 2] = v % 2 ? -1 : 1;
}

static void add_normal(const int corner[3], double normal[3])
{
    double one[3], other[3];
    for (int k = 0; k < 3; k++) {
        one[k] = at[corner[1]][k] - at[corner[0]][k];
        other[k] = at[corner[2]][k] - at[corner[0]][k];
    }
    for (int k = 0; k < 3; k++)
        normal[k] += one[(k + 1) % 3] * other[(k + 2) % 3] -
                     one[(k + 2) % 3] * other[(k + 1) % 3];
}

void normal_of(int vertex, double normal[3])
{
    for (int k = 0; k < 3; k++)
        normal[k] = 0;
    for (int t = 0; t < SIDES; t++)
        if (side[t][0] == vertex || side[t][1] == vertex ||
            side[t][2] == vertex)
            add_normal(side[t], normal);
}

static double volume(void)
{
    double sum = 0;
    for (int t = 0; t < SIDES; t++) {
        double normal[3] = {0};
        add_normal(side[t], normal);
        for (int k = 0; k < 3; k++)
            sum += at[side[t][0]][k] * normal[k] / 6;
    }
    return sum;
}

/// Returns what is left, which with what is gained must be the debt.
static double pay(int count, const int vertex[], double debt, double most)
{
    double before = volume();
    check_input("an octahedron, the first corner at %s; %d vertices, the first "
                "of them %d; debt = %.17g, most = %.17g",
                text_point(3, at[0]), count, vertex[0], debt, most);
    double left;
    check_value(left, give_back(count, vertex, debt, most, at));
    check_also(at);
    check_near(debt, volume() - before + left, 1e-12);
    return left;
}

// A vertex of this one gains 2/3 for each unit by which it moves out.
TEST(two_opposite_vertices)
{
    reset();
    check_near(0, pay(2, (int[]){4, 5}, 0.4, 1), 1e-14);
    check_near(1.3, at[4][2], 1e-14);
    check_near(-1.3, at[5][2], 1e-14);
}

TEST(a_debt_may_be_negative)
{
    reset();
    check_near(0, pay(1, (int[]){0}, -0.2, 1), 1e-14);
    check_near(0.7, at[0][0], 1e-14);
}

// The first would have to move by 7.5, as its star is thin, and the second, by
// 0.15 for both.
TEST(who_cannot_pay_stays)
{
    reset();
    at[2][1] = at[4][2] = 0.01;
    at[3][1] = at[5][2] = -0.01;
    double x = at[0][0];
    double left = pay(2, (int[]){0, 4}, 0.001, 0.2);
    check_real(x, at[0][0]);
    check_near(0, left, 1e-12);
}

TEST(nobody_can_pay)
{
    reset();
    check_near(7, pay(3, (int[]){0, 2, 4}, 7, 0.01), 1e-14);
    for (int v = 0; v < VERTICES; v++)
        check_real(v % 2 ? -1 : 1, at[v][v / 2]);
}

TEST(neighbors_at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        reset();
        for (int v = 0; v < VERTICES; v++)
            for (int k = 0; k < 3; k++)
                at[v][k] += uniform(&random, -0.2, 0.2);
        const int four[] = {0, 2, 1, 4};
        double left = pay(4, four, uniform(&random, -0.1, 0.1), 1);
        check_near(0, left, 1e-12);
    }
}

void run_tests(void)
{
    check_run(1, two_opposite_vertices);
    check_run(1, a_debt_may_be_negative);
    check_run(1, who_cannot_pay_stays);
    check_run(1, nobody_can_pay);
    check_run(1, neighbors_at_random);
}
