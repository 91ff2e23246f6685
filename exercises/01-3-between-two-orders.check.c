#include "check.h"

#include "support/oracle.h"

typedef struct encounter {
    double point[2];
    double edge[2][2][2];
} encounter;

encounter between_two_orders(void);

static bool hits(const tf_worldline *point, const tf_worldline edge[2])
{
    mpq_t toi;
    mpq_init(toi);
    bool hits = oracle_meet(2, 1, point, 2, edge, toi);
    mpq_clear(toi);
    return hits;
}

TEST(hits_in_one_order_only)
{
    check_input("none: the function gives an encounter");
    encounter e;
    check_value(e, between_two_orders());
    tf_worldline point = tf_worldline_between(2, e.point, e.point);
    tf_worldline edge[2], turned[2];
    for (int v = 0; v < 2; v++) {
        edge[v] = tf_worldline_between(2, e.edge[v][0], e.edge[v][1]);
        turned[1 - v] = edge[v];
    }
    check_finite(2, 1, &point);
    check_finite(2, 2, edge);
    check_input("point %s\n%s", text_point(2, e.point),
                text_lines(2, "vertex", 2, edge));
    check_picture(2, 1, &point, 2, edge);
    check_that(hits(&point, edge), "a hit in the order 0, 1",
               "no hit in the order 0, 1");
    check_that(!hits(&point, turned), "no hit in the order 1, 0",
               "a hit in the order 1, 0");
}

void run_tests(void)
{
    check_run(1, hits_in_one_order_only);
}
