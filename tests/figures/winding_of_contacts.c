#include "figures/numbers.h"

static const double at[2][2][2][2] = {
    {{{-0.25, 0.25}, {0.25, -1.5}}, {{-1.5, 1.5}, {1, 0.25}}},
    {{{-0.75, 0.25}, {0.75, 1}}, {{1.5, -1}, {1, -1}}}};

static void make_edges(tf_worldline edge[2][2])
{
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            edge[k][i] = tf_worldline_between(2, at[k][i][0], at[k][i][1]);
}

/// Whether the edges, straight at both ends of the step, cross.
static bool cross_at(tf_worldline edge[2][2], int t)
{
    oracle_simplex s = {2, {&edge[0][0].at[t], &edge[0][1].at[t]}};
    oracle_simplex r = {2, {&edge[1][0].at[t], &edge[1][1].at[t]}};
    return oracle_slices_meet(2, &s, &r);
}

static int compare(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/// The times at which an end meets a simplex of the other edge, in order.
static int find_times(tf_worldline edge[2][2], double time[8])
{
    int count = 0;
    mpq_t toi;
    mpq_init(toi);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            for (int pivot = 0; pivot < 2; pivot++) {
                oracle_simplex path = oracle_step(1, &edge[k][i], 0);
                oracle_simplex sweep = oracle_step(2, edge[1 - k], pivot);
                if (oracle_simplices_meet(2, &path, &sweep, toi))
                    time[count++] = mpq_get_d(toi);
            }
    mpq_clear(toi);
    qsort(time, (size_t)count, sizeof *time, compare);
    return count;
}

START_TEST(signs_sum_to_what_the_winding_number_gains)
{
    tf_worldline edge[2][2];
    double time[8] = {0}, sum = 0;
    char *text = printed(&fig_winding_of_contacts), key[16];
    make_edges(edge);
    ck_assert_int_eq(find_times(edge, time), 3);
    for (int i = 0; i < 3; i++) {
        snprintf(key, sizeof key, "toi_%d", i);
        expect_number(text, key, time[i]);
        snprintf(key, sizeof key, "sign_%d", i);
        ck_assert_double_eq(fabs(number_of(text, key)), 1);
        sum += number_of(text, key);
    }
    expect_number(text, "winding_start", cross_at(edge, 0));
    expect_number(text, "winding_end", cross_at(edge, 1));
    expect_number(text, "winding_end", sum);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/winding_of_contacts",
                    signs_sum_to_what_the_winding_number_gains);
}
