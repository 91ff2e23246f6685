#include "check.h"

#include "intersect/cascade.h"
#include "support/oracle.h"
#include "support/rational.h"
#include "support/support.h"

bool cross_at_end(const tf_arithmetic *arithmetic, bool cross_at_start,
                  const tf_worldline edge[2], const tf_worldline triangle[3]);

static bool cross_at(const tf_worldline e[2], const tf_worldline v[3], int t)
{
    oracle_simplex s = {2, {&e[0].at[t], &e[1].at[t]}};
    oracle_simplex r = {3, {&v[0].at[t], &v[1].at[t], &v[2].at[t]}};
    return oracle_slices_meet(3, &s, &r);
}

static tf_worldline random_line(generator *random)
{
    double x[2][3];
    for (int i = 0; i < 6; i++)
        x[i / 3][i % 3] = below(random, 2001) - 1000;
    return tf_worldline_between(3, x[0], x[1]);
}

TEST(anywhere)
{
    generator random = generator_new(0);
    for (int i = 0; i < 300; i++) {
        tf_worldline v[5];
        for (int j = 0; j < 5; j++)
            v[j] = random_line(&random);
        bool start = cross_at(v, v + 2, 0), end = cross_at(v, v + 2, 1);
        check_input("%s\n%s\n%s", text_lines(3, "edge, vertex", 2, v),
                    text_lines(3, "triangle, vertex", 3, v + 2),
                    start ? "They cross at the start."
                          : "They do not cross at the start.");
        bool got;
        check_value(got, cross_at_end(&oracle_arithmetic, start, v, v + 2));
        check_bool(end, got);
    }
}

void run_tests(void)
{
    check_run(1, anywhere);
}
