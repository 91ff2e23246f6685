#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "query/query.h"

static const double corner[4][3] = {
    {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

static double lerp(double from, double to, double part)
{
    return from + part * (to - from);
}

/// In a straight motion they meet at that time.  The step's own motion bends
/// the edge within what it sweeps over, so it has the same contact later.
START_TEST(the_edges_meet)
{
    char *text = printed(&fig_corner_past_triangle);
    expect_number(text, "volume_start", 8.0 / 3);
    expect_number(text, "volume_end", -2.0 / 3);
    static const double end[] = {0.5, 0.5, -3};
    tf_worldline line[4];
    for (int i = 0; i < 4; i++)
        line[i] = tf_worldline_between(3, corner[i], i == 0 ? end : corner[i]);
    tf_worldline side[2] = {line[0], line[3]};
    tf_contact contact;
    tf_query(&tf_exact, 3, 2, line + 1, 2, side, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    double t = number_of(text, "time");
    for (int k = 0; k < 3; k++) {
        double moved = lerp(corner[0][k], end[k], t);
        double middle = (corner[1][k] + corner[2][k]) / 2;
        ck_assert_double_eq_tol(lerp(corner[3][k], moved, 0.625), middle,
                                1e-15);
    }
    tf_query(&tf_exact, 3, 1, line, 3, line + 1, &contact);
    ck_assert_int_eq(contact.verdict, TF_APART);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/corner_past_triangle", the_edges_meet);
}
