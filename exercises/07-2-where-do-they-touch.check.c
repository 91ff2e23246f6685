#include "check.h"

#include "query/query.h"
#include "support/queries.h"
#include "support/rational.h"

void place_on_edge(const tf_worldline edge[2], const double weight[2], double t,
                   double place[3]);

static void ask(const tf_worldline edge[2], const double weight[2], double t,
                double got[3])
{
    check_input("%s\nweights: %s, t = %s", text_lines(3, "vertex", 2, edge),
                text_point(2, weight), text_real(t));
    check_call_n(3, got, place_on_edge(edge, weight, t, got));
}

TEST(middle_of_a_propeller)
{
    const tf_worldline edge[2] = {
        tf_worldline_between(3, (double[]){-1, 0, 0}, (double[]){-1, 0, -1}),
        tf_worldline_between(3, (double[]){1, 0, 0}, (double[]){1, 0, 1})};
    const double height[] = {0, 0.25, 0.5, 0.25, 0};
    for (int i = 0; i < 5; i++) {
        double got[3] = {0};
        ask(edge, (double[]){0.5, 0.5}, i / 4.0, got);
        check_point(3, ((const double[]){0, 0, height[i]}), got, 1e-15);
    }
}

TEST(both_edges_are_there)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        query q = query_soup(&random, EDGE_EDGE);
        tf_contact contact;
        tf_query(&oracle_arithmetic, 3, 2, &q.vertex[0], 2, &q.vertex[2],
                 &contact);
        if (contact.verdict != TF_HIT)
            continue;
        double first[3] = {0}, second[3] = {0};
        staircase_point(3, 2, &q.vertex[2], contact.barycentric[1],
                        contact.toi_lo, second);
        ask(&q.vertex[0], contact.barycentric[0], contact.toi_lo, first);
        check_point(3, second, first, 1e-9);
    }
}

void run_tests(void)
{
    check_run(1, middle_of_a_propeller);
    check_run(1, both_edges_are_there);
}
