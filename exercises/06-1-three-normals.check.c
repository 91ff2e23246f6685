#include "check.h"

#include "geometry/sweep.h"

void simplex_normal(const tf_simplex *simplex, double normal[3]);

typedef struct expectation {
    double triangle[3][2][3]; // [vertex][time][axis]
    double normal[3][3];      // of the simplices with pivots 2, 1, 0
} expectation;

static const expectation expected[] = {
    // It rises: it keeps its normal.
    {{{{0, 0, 0}, {0, 0, 1}}, {{2, 0, 0}, {2, 0, 1}}, {{0, 3, 0}, {0, 3, 1}}},
     {{0, 0, 6}, {0, 0, 6}, {0, 0, 6}}},
    // It turns from the floor, where z = 0, up to the wall, where y = 0.
    {{{{0, 0, 0}, {0, 0, 0}}, {{2, 0, 0}, {2, 0, 0}}, {{0, 3, 0}, {0, 0, 3}}},
     {{0, 0, 6}, {0, -6, 0}, {0, -6, 0}}},
    {{{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 2}}},
     {{0, 0, 1}, {0, -2, -1}, {2, 2, 1}}},
};

TEST(is_that_of_the_horizontal_edges)
{
    const expectation *given = &expected[_i];
    tf_worldline triangle[3];
    for (int v = 0; v < 3; v++)
        triangle[v] = tf_worldline_between(3, given->triangle[v][0],
                                           given->triangle[v][1]);
    tf_simplex sweep[3];
    tf_sweep(3, triangle, sweep);
    for (int i = 0; i < 3; i++) {
        double got[3] = {0};
        check_input("the simplex with pivot %d of\n%s", sweep[i].pivot,
                    text_lines(3, "vertex", 3, triangle));
        check_call(got, simplex_normal(&sweep[i], got));
        check_point(3, given->normal[i], got, 0);
    }
}

void run_tests(void)
{
    check_run(sizeof expected / sizeof *expected,
              is_that_of_the_horizontal_edges);
}
