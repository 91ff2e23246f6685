#include "check.h"

#include "support/support.h"

void find_quadratic(const tf_worldline *point, const tf_worldline edge[2],
                    double c[3]);

static void expect(const double expected[3], const tf_worldline *point,
                   const tf_worldline edge[2])
{
    check_input("point: %s\n%s", text_line(2, point),
                text_lines(2, "end", 2, edge));
    check_picture(2, 1, point, 2, edge);
    double c[3] = {0};
    check_call(c, find_quadratic(point, edge, c));
    for (int i = 0; i < 3; i++)
        check_that(c[i] == expected[i], text_real(expected[i]), "c[%d] = %s", i,
                   text_real(c[i]));
}

TEST(is_that_of_the_running_example)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){1, 3}, (double[]){2, 0});
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 1}),
        tf_worldline_between(2, (double[]){4, 0}, (double[]){4, 2})};
    expect((const double[]){12, -17, -1}, &point, edge);
}

/// The determinant at a time, of places of integers.
static double value_at(const tf_worldline *point, const tf_worldline edge[2],
                       double t)
{
    double d[2][2];
    for (int k = 0; k < 2; k++) {
        double first = (1 - t) * edge[0].at[0].x[k] + t * edge[0].at[1].x[k];
        d[0][k] = (1 - t) * edge[1].at[0].x[k] + t * edge[1].at[1].x[k] - first;
        d[1][k] = (1 - t) * point->at[0].x[k] + t * point->at[1].x[k] - first;
    }
    return d[0][0] * d[1][1] - d[0][1] * d[1][0];
}

TEST(has_the_values_of_the_determinant)
{
    generator random = generator_new(0);
    for (int i = 0; i < 200; i++) {
        tf_worldline line[3];
        for (int j = 0; j < 3; j++) {
            double at[2][2];
            for (int k = 0; k < 4; k++)
                at[k / 2][k % 2] = below(&random, 19) - 9;
            line[j] = tf_worldline_between(2, at[0], at[1]);
        }
        // Three values determine a quadratic.
        double start = value_at(&line[0], line + 1, 0);
        double end = value_at(&line[0], line + 1, 1);
        double before = value_at(&line[0], line + 1, -1);
        expect((const double[]){start, (end - before) / 2,
                                (end + before) / 2 - start},
               &line[0], line + 1);
    }
}

void run_tests(void)
{
    check_run(1, is_that_of_the_running_example);
    check_run(1, has_the_values_of_the_determinant);
}
