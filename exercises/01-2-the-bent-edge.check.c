#include "check.h"

void bent_edge(const tf_worldline edge[2], double t, double corner[3][2]);

typedef struct bent {
    double edge[2][2][2]; // [vertex][time][axis]
    double t, corner[3][2];
} bent;

static const bent expected[] = {
    // An edge that is shifted stays straight.
    {{{{0, 0}, {0, 2}}, {{4, 0}, {4, 2}}}, 0.5, {{0, 1}, {2, 1}, {4, 1}}},
    {{{{0, 0}, {0, 2}}, {{4, 0}, {4, 2}}},
     0.25,
     {{0, 0.5}, {1, 0.5}, {4, 0.5}}},
    // One that is turned bends, as the one of the chapter does.
    {{{{0, 0}, {0, 1}}, {{4, 0}, {4, 2}}}, 0.5, {{0, 0.5}, {2, 1}, {4, 1}}},
    {{{{0, 0}, {4, 0}}, {{4, 4}, {0, 4}}}, 0.5, {{2, 0}, {0, 2}, {2, 4}}},
    {{{{0, 0}, {0, 4}}, {{4, 0}, {8, 0}}}, 0.75, {{0, 3}, {6, 0}, {7, 0}}},
};

TEST(has_three_corners)
{
    const bent *given = &expected[_i];
    tf_worldline edge[2];
    for (int v = 0; v < 2; v++)
        edge[v] = tf_worldline_between(2, given->edge[v][0], given->edge[v][1]);
    double corner[3][2] = {{0}};
    check_input("%s\nt = %s", text_lines(2, "vertex", 2, edge),
                text_real(given->t));
    check_call(corner, bent_edge(edge, given->t, corner));
    for (int i = 0; i < 3; i++)
        check_that(corner[i][0] == given->corner[i][0] &&
                       corner[i][1] == given->corner[i][1],
                   text_point(2, given->corner[i]), "%s as corner[%d]",
                   text_point(2, corner[i]), i);
}

void run_tests(void)
{
    check_run(sizeof expected / sizeof *expected, has_three_corners);
}
