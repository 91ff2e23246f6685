#include "check.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

enum {
    VERTICES = 6,
    SIDES = 8
};

void normal_of(int vertex, double normal[3]);
double restore_volume(int count, const int vertex[], double lost, double most,
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

/// Returns what is left, which with what is gained must be what was lost.
static double restore(int count, const int vertex[], double lost, double most)
{
    double before = volume();
    check_input("an octahedron, the first corner at %s; %d vertices, the first "
                "of them %d; lost = %.17g, most = %.17g",
                text_point(3, at[0]), count, vertex[0], lost, most);
    double left;
    check_value(left, restore_volume(count, vertex, lost, most, at));
    check_also(at);
    check_near(lost, volume() - before + left, 1e-12);
    return left;
}

// A vertex of this one gains 2/3 for each unit by which it moves out.
TEST(two_opposite_vertices_restore_equal_shares)
{
    reset();
    check_near(0, restore(2, (int[]){4, 5}, 0.4, 1), 1e-14);
    check_near(1.3, at[4][2], 1e-14);
    check_near(-1.3, at[5][2], 1e-14);
}

TEST(a_gain_is_taken_back)
{
    reset();
    check_near(0, restore(1, (int[]){0}, -0.2, 1), 1e-14);
    check_near(0.7, at[0][0], 1e-14);
}

// The first would have to move by 7.5, as its star is thin, and the second, by
// 0.15 for both.
TEST(a_vertex_that_would_go_too_far_stays)
{
    reset();
    at[2][1] = at[4][2] = 0.01;
    at[3][1] = at[5][2] = -0.01;
    double x = at[0][0];
    double left = restore(2, (int[]){0, 4}, 0.001, 0.2);
    check_real(x, at[0][0]);
    check_near(0, left, 1e-12);
}

TEST(what_no_vertex_can_restore_is_left)
{
    reset();
    check_near(7, restore(3, (int[]){0, 2, 4}, 7, 0.01), 1e-14);
    for (int v = 0; v < VERTICES; v++)
        check_real(v % 2 ? -1 : 1, at[v][v / 2]);
}

TEST(neighbors_restore_all)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        reset();
        for (int v = 0; v < VERTICES; v++)
            for (int k = 0; k < 3; k++)
                at[v][k] += uniform(&random, -0.2, 0.2);
        const int four[] = {0, 2, 1, 4};
        double left = restore(4, four, uniform(&random, -0.1, 0.1), 1);
        check_near(0, left, 1e-12);
    }
}

void run_tests(void)
{
    check_run(1, two_opposite_vertices_restore_equal_shares);
    check_run(1, a_gain_is_taken_back);
    check_run(1, a_vertex_that_would_go_too_far_stays);
    check_run(1, what_no_vertex_can_restore_is_left);
    check_run(1, neighbors_restore_all);
}
