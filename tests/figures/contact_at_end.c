#include "figures/numbers.h"

/// When the triangles of a start event and two end events first meet, all in
/// the plane z = 0.
static double first_time(const double start[2][2], const double end[2][2][2])
{
    tf_worldline vertex[2][2];
    oracle_simplex simplex[2];
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 2; i++)
            vertex[k][i] =
                tf_worldline_between(3, (double[]){start[k][0], start[k][1], 0},
                                     (double[]){end[k][i][0], end[k][i][1], 0});
        simplex[k] = oracle_step(2, vertex[k], 0);
    }
    mpq_t toi;
    mpq_init(toi);
    bool meet = oracle_simplices_meet(3, &simplex[0], &simplex[1], toi);
    double time = meet ? mpq_get_d(toi) : -1;
    mpq_clear(toi);
    return time;
}

START_TEST(edges_that_cross_at_the_end_cross_before)
{
    static const double start[2][2] = {{-1, 1.5}, {2, 0.5}};
    static const double crossing[2][2][2] = {{{0, 0}, {2, 0}},
                                             {{1, -1}, {1, 1}}};
    static const double touching[2][2][2] = {{{-1, 0}, {1, 0}},
                                             {{1, -1}, {1, 1}}};
    char *text = printed(&fig_contact_at_end);
    expect_number(text, "crossing_first", first_time(start, crossing));
    expect_number(text, "crossing_first", 0.75);
    expect_number(text, "touching_first", first_time(start, touching));
    expect_number(text, "touching_first", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/contact_at_end",
                    edges_that_cross_at_the_end_cross_before);
}
