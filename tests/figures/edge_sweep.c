#include "figures/numbers.h"

#include "support/oracle.h"
#include "support/queries.h"

START_TEST(contact_is_where_the_oracle_has_it)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){1, 3}, (double[]){2, 0});
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 1}),
        tf_worldline_between(2, (double[]){4, 0}, (double[]){4, 2})};
    char *text = printed(&fig_edge_sweep);
    double lo = number_of(text, "toi_lo"), hi = number_of(text, "toi_hi");
    double weight[2] = {number_of(text, "barycentric_e0"),
                        number_of(text, "barycentric_e1")};

    mpq_t toi, end;
    mpq_inits(toi, end, NULL);
    ck_assert(oracle_meet(2, 1, &point, 2, edge, toi));
    mpq_set_d(end, lo);
    ck_assert_msg(mpq_cmp(end, toi) <= 0, "toi_lo %.17g is late", lo);
    mpq_set_d(end, hi);
    ck_assert_msg(mpq_cmp(toi, end) <= 0, "toi_hi %.17g is early", hi);

    double t = mpq_get_d(toi), at[2], on[2], one = 1;
    staircase_point(2, 1, &point, &one, t, at);
    staircase_point(2, 2, edge, weight, t, on);
    for (int k = 0; k < 2; k++)
        ck_assert_msg(fabs(at[k] - on[k]) <= 1e-14,
                      "axis %d: the point is at %.17g, the edge at %.17g", k,
                      at[k], on[k]);
    ck_assert_double_eq_tol(weight[0] + weight[1], 1, 1e-15);
    mpq_clears(toi, end, NULL);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/edge_sweep", contact_is_where_the_oracle_has_it);
}
