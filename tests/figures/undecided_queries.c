#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "intersect/signs.h"
#include "kit/random.h"

enum {
    QUERIES = 1 << 14,
    VERTICES = 4
};

static bool separated(int first, const tf_worldline vertex[VERTICES])
{
    for (int k = 0; k < 3; k++) {
        bool below = true, above = true;
        for (int t = 0; t < 2; t++)
            for (int a = 0; a < first; a++)
                for (int b = first; b < VERTICES; b++) {
                    double x = vertex[a].at[t].x[k], y = vertex[b].at[t].x[k];
                    below &= x < y;
                    above &= x > y;
                }
        if (below || above)
            return true;
    }
    return false;
}

/// Whether signs other than zero decide the query: all six of some pair are the
/// same, or every pair has two that are opposite.
static bool decided(int first, const tf_worldline vertex[VERTICES])
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    int second = VERTICES - first;
    bool conflict = true;
    tf_sweep(first, vertex, s);
    tf_sweep(second, vertex + first, r);
    for (int i = 0; i < first * second; i++) {
        tf_pair pair = tf_pair_of(&s[i / second], &r[i % second], 3);
        int positive = 0, negative = 0;
        for (int e = 0; e < pair.count; e++) {
            tf_differences d;
            tf_pair_differences(&pair, e, &d);
            int sign = tf_exact.sign(&d) * tf_pair_orientation(&pair, e);
            positive += sign > 0;
            negative += sign < 0;
        }
        if (positive == pair.count || negative == pair.count)
            return true;
        conflict &= positive > 0 && negative > 0;
    }
    return conflict;
}

/// Determinants of such small integers have no errors.
static double percent_on_lattice(int first)
{
    uint64_t random = 15;
    int count = 0;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        double x[2][VERTICES][3];
        for (int j = 0; j < 2 * VERTICES * 3; j++)
            x[j / (VERTICES * 3)][j / 3 % VERTICES][j % 3] =
                floor(4 * fig_random_number(&random));
        for (int v = 0; v < VERTICES; v++)
            vertex[v] = tf_worldline_between(3, x[0][v], x[1][v]);
        count += !separated(first, vertex) && !decided(first, vertex);
    }
    return 100.0 * count / QUERIES;
}

START_TEST(zeros_are_undecided)
{
    char *text = printed(&fig_undecided_queries);
    expect_number(text, "pt_lattice", percent_on_lattice(1));
    expect_number(text, "ee_lattice", percent_on_lattice(2));
    static const char *const easy[] = {"pt_soup", "ee_soup", "pt_near",
                                       "ee_near"};
    for (int i = 0; i < 4; i++)
        expect_number(text, easy[i], 0);
    expect_number(text, "pt_huge", 100);
    expect_number(text, "ee_huge", 100);
    ck_assert_double_gt(number_of(text, "pt_contact"), 80);
    ck_assert_double_gt(number_of(text, "ee_contact"), 80);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/undecided_queries", zeros_are_undecided);
}
