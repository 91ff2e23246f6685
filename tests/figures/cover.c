#include "figures/numbers.h"

#include "support/oracle.h"

#include <math.h>

enum {
    CORNERS = 32
};

static tf_worldline corner(int i)
{
    const double whole = 2 * acos(-1);
    double from = whole * i / CORNERS, to = from + whole * 114 / 360;
    return tf_worldline_between(2,
                                (double[]){0.78 * cos(from), 0.78 * sin(from)},
                                (double[]){0.64 * cos(to), 0.64 * sin(to)});
}

START_TEST(the_point_enters_the_ring_once)
{
    tf_worldline point = tf_worldline_between(2, (double[]){0.62, -0.95},
                                              (double[]){-0.12, 0.3});
    int hits = 0;
    mpq_t toi;
    mpq_init(toi);
    char *text = printed(&fig_cover);
    for (int i = 0; i < CORNERS; i++) {
        bool last = i == CORNERS - 1;
        tf_worldline edge[2] = {corner(last ? 0 : i), corner(last ? i : i + 1)};
        if (!oracle_meet(2, 1, &point, 2, edge, toi))
            continue;
        hits++;
        ck_assert_double_eq(number_of(text, "hit_edge"), i);
        ck_assert_double_eq_tol(number_of(text, "toi"), mpq_get_d(toi), 1e-14);
    }
    ck_assert_int_eq(hits, 1);
    ck_assert_double_eq(number_of(text, "hits"), 1);
    mpq_clear(toi);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/cover", the_point_enters_the_ring_once);
}
