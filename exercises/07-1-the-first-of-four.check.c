#include "check.h"

#include "intersect/cascade.h"
#include "support/oracle.h"
#include "support/queries.h"
#include "support/rational.h"

#include <math.h>

tf_intersection first_of_four(const tf_arithmetic *arithmetic,
                              const tf_worldline first[2],
                              const tf_worldline second[2]);

static void expect_first(const tf_worldline first[2],
                         const tf_worldline second[2])
{
    check_input("%s\n%s", text_lines(3, "first, vertex", 2, first),
                text_lines(3, "second, vertex", 2, second));
    check_picture(3, 2, first, 2, second);
    tf_intersection got;
    check_value(got, first_of_four(&oracle_arithmetic, first, second));
    mpq_t toi;
    mpq_init(toi);
    bool meet = oracle_meet(3, 2, first, 2, second, toi);
    double expected = mpq_get_d(toi);
    mpq_clear(toi);
    check_that((got.verdict == TF_HIT) == meet, meet ? "TF_HIT" : "TF_APART",
               "%s", got.verdict == TF_HIT ? "TF_HIT" : "TF_APART");
    if (meet)
        check_near(expected, (got.toi_lo + got.toi_hi) / 2, 1e-12);
}

TEST(edges_anywhere)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        query q = query_soup(&random, EDGE_EDGE);
        for (int j = 0; j < query_size(&q); j++) {
            // Few digits are easier to read.
            double *x = query_coordinate(&q, j);
            *x = round(*x * 1000);
        }
        expect_first(&q.vertex[0], &q.vertex[2]);
    }
}

void run_tests(void)
{
    check_run(1, edges_anywhere);
}
