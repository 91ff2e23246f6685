#include "check.h"

#include "geometry/event.h"
#include "support/oracle.h"
#include "support/queries.h"

bool point_meets_edge(const tf_worldline *point, const tf_worldline edge[2]);

/// Twice the area of the triangle that three of the edge's events make in the
/// frame of the point.
static double area(const tf_worldline *point, const tf_event *const e[3])
{
    double p[3][2];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            p[i][k] = e[i]->x[k] - point->at[e[i]->t].x[k];
    return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
           (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
}

static void expect(const tf_worldline *point, const tf_worldline edge[2])
{
    const tf_event *a = edge[0].at, *b = edge[1].at;
    if (area(point, (const tf_event *[]){&a[0], &b[0], &b[1]}) == 0 ||
        area(point, (const tf_event *[]){&a[0], &a[1], &b[1]}) == 0)
        return;
    mpq_t toi;
    mpq_init(toi);
    bool expected = oracle_meet(2, 1, point, 2, edge, toi);
    mpq_clear(toi);
    check_input("point: %s\n%s", text_line(2, point),
                text_lines(2, "vertex", 2, edge));
    check_picture(2, 1, point, 2, edge);
    bool got;
    check_value(got, point_meets_edge(point, edge));
    check_bool(expected, got);
}

TEST(a_point_falls_on_an_edge)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){1, 2}, (double[]){1, -2});
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 0}),
        tf_worldline_between(2, (double[]){4, 0}, (double[]){4, 0})};
    expect(&point, edge);
}

TEST(small_integers)
{
    generator random = generator_new(0);
    for (int i = 0; i < 2000; i++) {
        query q = query_lattice(&random, POINT_EDGE, 4);
        expect(&q.vertex[0], &q.vertex[1]);
    }
}

void run_tests(void)
{
    check_run(1, a_point_falls_on_an_edge);
    check_run(1, small_integers);
}
