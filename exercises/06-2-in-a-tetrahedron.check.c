#include "check.h"

#include "support/oracle.h"
#include "support/support.h"

bool holds_origin(const double p[4][3]);

/// Six times the volume of the tetrahedron.
static double volume(const double p[4][3])
{
    double e[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            e[i][k] = p[i + 1][k] - p[0][k];
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
           e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

static void expect(const double p[4][3])
{
    if (volume(p) == 0)
        return;
    tf_event origin = {.t = 0}, corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = (tf_event){.x = {p[i][0], p[i][1], p[i][2]}};
    oracle_simplex s = {1, {&origin}};
    oracle_simplex r = {4, {&corner[0], &corner[1], &corner[2], &corner[3]}};
    bool expected = oracle_slices_meet(3, &s, &r);
    check_input("the corners %s, %s,\n%s, %s", text_point(3, p[0]),
                text_point(3, p[1]), text_point(3, p[2]), text_point(3, p[3]));
    bool got;
    check_value(got, holds_origin(p));
    check_bool(expected, got);
}

TEST(one_around_the_origin)
{
    expect(
        (const double[4][3]){{2, 0, -1}, {-1, 2, -1}, {-1, -2, -1}, {0, 0, 3}});
    expect(
        (const double[4][3]){{2, 0, -1}, {-1, -2, -1}, {-1, 2, -1}, {0, 0, 3}});
}

TEST(small_integers)
{
    generator random = generator_new(0);
    for (int i = 0; i < 2000; i++) {
        double p[4][3];
        for (int j = 0; j < 12; j++)
            p[j / 3][j % 3] = below(&random, 5) - 2;
        expect((const double(*)[3])p);
    }
}

void run_tests(void)
{
    check_run(1, one_around_the_origin);
    check_run(1, small_integers);
}
