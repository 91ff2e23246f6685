#include "figures/rows.h"
#include "figures/timed.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "query/query.h"

// Signs of small integers --------------------------------------------------

static long signs, cancelled;

/// The sum of the absolute values of all products of a determinant.
static double sum_of_sizes(const tf_differences *d)
{
    double e[TF_AXES][TF_AXES] = {{0}};
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < d->n; j++) {
            int k = d->axis[j];
            e[i][j] = fabs(d->to[i]->x[k] - d->from[i]->x[k]);
        }
    if (d->n == 2)
        return e[0][0] * e[1][1] + e[0][1] * e[1][0];
    double sum = 0;
    for (int j = 0; j < 3; j++) {
        int a = (j + 1) % 3, b = (j + 2) % 3;
        sum += e[0][j] * (e[1][a] * e[2][b] + e[1][b] * e[2][a]);
    }
    return sum;
}

static tf_sign noting_sign(const tf_differences *differences)
{
    tf_sign sign = tf_exact.sign(differences);
    signs++;
    cancelled += sign == TF_ZERO && sum_of_sizes(differences) > 0;
    return sign;
}

/// No verdict depends on values.
static tf_value any_value(const tf_differences *differences)
{
    (void)differences;
    return (tf_value){.number = 1};
}

/// The percentage of queries that ask for no sign, and for one that is zero
/// though not all of its products are.
static void find_shares(const workload *w, double *none, double *open)
{
    static const tf_arithmetic noting = {
        .name = "noting", .sign = noting_sign, .value = any_value};
    long without = 0, with_open = 0;
    for (long i = 0; i < w->count; i++) {
        const tf_worldline *v = w->queries[i].vertex;
        tf_contact contact;
        signs = cancelled = 0;
        ck_assert_int_eq(tf_query(&noting, TF_AXES, w->vertices, v,
                                  QUERY_VERTICES - w->vertices, v + w->vertices,
                                  &contact),
                         TF_OK);
        without += signs == 0;
        with_open += cancelled > 0;
    }
    *none = 100. * (double)without / (double)w->count;
    *open = 100. * (double)with_open / (double)w->count;
}

/// Whether all of one element is beyond all of the other on an axis, as far as
/// two steps of their staircases go, at both times in the same sense.
static bool beside(const tf_worldline v[], int vertices, int s_pivot,
                   int r_pivot, int axis)
{
    int above[2] = {0, 0}, below[2] = {0, 0}, pairs[2] = {0, 0};
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < QUERY_VERTICES - vertices; j++)
            for (int t = 0; t < 2; t++) {
                bool s_has = t == 0 ? i <= s_pivot : i >= s_pivot;
                bool r_has = t == 0 ? j <= r_pivot : j >= r_pivot;
                if (!s_has || !r_has)
                    continue;
                double s = v[i].at[t].x[axis],
                       r = v[vertices + j].at[t].x[axis];
                pairs[t]++;
                above[t] += s > r;
                below[t] += s < r;
            }
    return (above[0] == pairs[0] && above[1] == pairs[1]) ||
           (below[0] == pairs[0] && below[1] == pairs[1]);
}

/// Whether an axis separates every pair of steps, so that nothing is computed.
static bool needs_no_sign(const workload *w, const tf_worldline v[])
{
    for (int i = 0; i < w->vertices; i++)
        for (int j = 0; j < QUERY_VERTICES - w->vertices; j++) {
            bool separated = false;
            for (int k = 0; k < TF_AXES; k++)
                separated = separated || beside(v, w->vertices, i, j, k);
            if (!separated)
                return false;
        }
    return true;
}

static double percent_without_signs(const workload *w)
{
    long count = 0;
    for (long i = 0; i < w->count; i++)
        count += needs_no_sign(w, w->queries[i].vertex);
    return 100. * (double)count / (double)w->count;
}

// Tests --------------------------------------------------------------------

static const double unit = 0.001 + 1e-9; // of percents

/// The signs that estimates leave open are those near zero.  Of small integers
/// these are zero, but for those all of whose products are zero too; of random
/// numbers there are none, and of vertices of one plane all are.  All of them
/// are on a grid.
START_TEST(shares_are_those_of_the_queries)
{
    char *text = printed(&fig_sign_stages);
    workload w = timed_workload(_i);
    double none, open, expected = percent_without_signs(&w);
    find_shares(&w, &none, &open);
    ck_assert_double_eq(none, expected);
    bool rest = strcmp(w.name, "rest") == 0;
    if (rest)
        open = 100;
    expect_timed(text, &w, "none", none, unit);
    expect_timed(text, &w, "grid", open, unit);
    expect_timed(text, &w, "accumulator", 0, 0);
    expect_timed(text, &w, "estimate", 100 - none - open, 2 * unit);
    free(text);
    workload_free(&w);
}
END_TEST

/// Differences of small integers are not rounded; those of the tilted cloth
/// are, sometimes.
START_TEST(tails_are_where_differences_are_rounded)
{
    char *text = printed(&fig_sign_stages);
    workload w = timed_workload(_i);
    double tails = timed_number(text, &w, "tails");
    double heads = timed_number(text, &w, "heads");
    bool rest = strcmp(w.name, "rest") == 0;
    ck_assert_msg((tails > 0) == rest, "%s: %g percent of tails", w.name,
                  tails);
    ck_assert_msg(0 <= heads && heads <= tails && tails <= 100,
                  "%s: %g percent of heads, %g of tails", w.name, heads, tails);
    free(text);
    workload_free(&w);
}
END_TEST

START_TEST(times_are_those_of_their_ways)
{
    static const char *const ways[][2] = {
        {"ns_estimate", "estimate"},
        {"ns_grid", "grid"},
        {"ns_whole", "accumulator"},
        {"ns_accumulator", "accumulator with tails"},
        {"ns_any_size", "accumulator of any size"},
        {"ns_expansion", "expansion"},
        {"ns_grid_integers", "grid of integers"},
        {"ns_integers", "accumulator of integers"},
        {"ns_expansion_integers", "expansion of integers"},
        {"ns_grid_plane", "grid in the plane"},
        {"ns_plane", "accumulator in the plane"},
        {"ns_expansion_plane", "expansion in the plane"}};
    char *text = printed(&fig_sign_stages);
    double estimate = number_of(text, "ns_estimate");
    ck_assert_double_gt(estimate, 1);
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        expect_number(text, ways[i][0], row_value(ways[i][1]));
        // All begin with an estimate.
        if (i > 0 && strstr(ways[i][0], "plane") == NULL)
            ck_assert_double_gt(number_of(text, ways[i][0]), estimate);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("figures/sign_stages");
    TCase *numbers = tcase_create("numbers");
    tcase_add_loop_test(numbers, shares_are_those_of_the_queries, 0,
                        TIMED_WORKLOADS);
    tcase_add_loop_test(numbers, tails_are_where_differences_are_rounded, 0,
                        TIMED_WORKLOADS);
    tcase_add_test(numbers, times_are_those_of_their_ways);
    suite_add_tcase(s, numbers);
    return s;
}
