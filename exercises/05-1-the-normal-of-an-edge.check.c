#include "check.h"

#include "geometry/sweep.h"

void edge_normal(const tf_simplex *simplex, double normal[2]);

typedef struct expectation {
    double edge[2][2][2]; // [vertex][time][axis]
    double normal[2][2];  // of the triangles with pivot 1 and pivot 0
} expectation;

static const expectation expected[] = {
    // The edge is turned from the x axis to the y axis.
    {{{{0, 0}, {0, 0}}, {{2, 0}, {0, 2}}}, {{0, 1}, {-1, 0}}},
    {{{{1, 1}, {0, 0}}, {{4, 5}, {-3, 4}}}, {{-0.8, 0.6}, {-0.8, -0.6}}},
    // It has no length at the end, or at the start.
    {{{{0, 0}, {1, 1}}, {{0, -5}, {1, 1}}}, {{1, 0}, {0, 0}}},
    {{{{1, 1}, {0, 0}}, {{1, 1}, {-7, 0}}}, {{0, 0}, {0, -1}}},
};

TEST(is_the_left_normal_of_the_horizontal_edge)
{
    const expectation *given = &expected[_i];
    tf_worldline edge[2];
    for (int v = 0; v < 2; v++)
        edge[v] = tf_worldline_between(2, given->edge[v][0], given->edge[v][1]);
    tf_simplex sweep[2];
    tf_sweep(2, edge, sweep);
    for (int i = 0; i < 2; i++) {
        double got[2] = {0};
        check_input("the triangle with pivot %d of\n%s", sweep[i].pivot,
                    text_lines(2, "vertex", 2, edge));
        check_call(got, edge_normal(&sweep[i], got));
        check_point(2, given->normal[i], got, 1e-15);
    }
}

void run_tests(void)
{
    check_run(sizeof expected / sizeof *expected,
              is_the_left_normal_of_the_horizontal_edge);
}
