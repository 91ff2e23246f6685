#include "check.h"

#include "geometry/sweep.h"

double relative_normal_velocity(const tf_simplex *point, const tf_simplex *edge,
                                const double normal[2]);

typedef struct expectation {
    double point[2][2], edge[2][2][2]; // [time][axis], [vertex][time][axis]
    double normal[2];
    double normal_velocity[2]; // for the triangles with pivot 1 and pivot 0
} expectation;

static const expectation expected[] = {
    // A point falls on an edge at rest, and an edge rises to a point.
    {{{1, 1}, {1, -2}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}}, {0, 1}, {-3, -3}},
    {{{1, 1}, {1, 1}}, {{{0, 0}, {0, 4}}, {{2, 0}, {2, 4}}}, {0, 1}, {-4, -4}},
    // Only one vertex moves: only its triangle has a velocity.
    {{{1, 1}, {1, 1}}, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 6}}}, {0, 1}, {-6, 0}},
    {{{1, 1}, {1, 0}}, {{{0, 0}, {0, 3}}, {{2, 0}, {2, 0}}}, {0, 1}, {-1, -4}},
    // Across: only the part along the normal counts.
    {{{0, 0}, {5, 0}}, {{{1, 0}, {1, 0}}, {{1, 2}, {1, 2}}}, {-1, 0}, {-5, -5}},
    {{{0, 0}, {5, 10}},
     {{{4, -3}, {4, -3}}, {{7, 1}, {7, 1}}},
     {-0.8, 0.6},
     {2, 2}},
};

TEST(is_relative_and_along_the_normal)
{
    const expectation *given = &expected[_i];
    tf_worldline point =
        tf_worldline_between(2, given->point[0], given->point[1]);
    tf_worldline edge[2];
    for (int v = 0; v < 2; v++)
        edge[v] = tf_worldline_between(2, given->edge[v][0], given->edge[v][1]);
    tf_simplex s[1], r[2];
    tf_sweep(1, &point, s);
    tf_sweep(2, edge, r);
    for (int i = 0; i < 2; i++) {
        check_input("point: %s\nthe triangle with pivot %d of\n%s\nnormal: %s",
                    text_line(2, &point), r[i].pivot,
                    text_lines(2, "vertex", 2, edge),
                    text_point(2, given->normal));
        check_picture(2, 1, &point, 2, edge);
        double got;
        check_value(got, relative_normal_velocity(&s[0], &r[i], given->normal));
        check_near(given->normal_velocity[i], got, 1e-14);
    }
}

void run_tests(void)
{
    check_run(sizeof expected / sizeof *expected,
              is_relative_and_along_the_normal);
}
