#include "figures/timed.h"

#include "support/moved_simplices.h"

/// Whether two moving elements meet, in one sense or another, and when.
typedef bool meet_test(int axes, int vertices, const tf_worldline first[],
                       int others, const tf_worldline second[], mpq_t toi);

static double count_hits(const workload *w, meet_test *meet)
{
    long hits = 0;
    mpq_t unused;
    mpq_init(unused);
    for (long i = 0; i < w->count; i++) {
        const tf_worldline *v = w->queries[i].vertex;
        hits += meet(TF_AXES, w->vertices, v, QUERY_VERTICES - w->vertices,
                     v + w->vertices, unused);
    }
    mpq_clear(unused);
    return (double)hits;
}

static void expect_hits(const char *text, const workload *w, int exact,
                        const char *const names[])
{
    double hits = count_hits(w, oracle_meet);
    for (int i = 0; i < exact; i++)
        expect_timed(text, w, names[i], hits, 0);
    // What is left open counts as a hit.
    ck_assert_double_ge(timed_number(text, w, "clamped_hits"), hits);
}

START_TEST(hits_are_the_oracles)
{
    static const char *const exact[] = {"exact_hits", "integer64_hits",
                                        "integer128_hits"};
    char *text = printed(&fig_sign_costs);
    workload w = timed_workload(_i);
    if (is_lattice(&w)) {
        expect_hits(text, &w, 3, exact);
    } else {
        workload grid = workload_rounded(&w);
        expect_hits(text, &w, 1, exact);
        expect_hits(text, &grid, 3, exact);
        workload_free(&grid);
    }
    free(text);
    workload_free(&w);
}
END_TEST

/// Moved by little, elements apart stay apart, and in general position those
/// that meet still do; the lattice's are moved by explicit numbers.
START_TEST(perturbed_hits_are_those_of_moved_queries)
{
    char *text = printed(&fig_sign_costs);
    workload w = timed_workload(_i);
    double hits = is_lattice(&w) ? count_hits(&w, moved_meet)
                                 : timed_number(text, &w, "exact_hits");
    expect_timed(text, &w, "perturbed_hits", hits, 0);
    ck_assert_double_le(hits, timed_number(text, &w, "exact_hits"));
    free(text);
    workload_free(&w);
}
END_TEST

static void expect_queries(const char *text, const workload *w, int count)
{
    static const char *const names[] = {"clamped", "exact", "perturbed",
                                        "integer64", "integer128"};
    for (int i = 0; i < count; i++) {
        char queries[32];
        snprintf(queries, sizeof queries, "%s_queries", names[i]);
        expect_timed(text, w, queries, (double)w->count, 0);
        // No processor decides a query in less.
        ck_assert_double_gt(timed_number(text, w, names[i]), 1);
    }
}

START_TEST(all_arithmetics_are_timed_on_all_queries)
{
    char *text = printed(&fig_sign_costs);
    workload w = timed_workload(_i);
    expect_queries(text, &w, is_lattice(&w) ? 5 : 3);
    if (!is_lattice(&w)) {
        w.rounded = true;
        expect_queries(text, &w, 5);
    }
    free(text);
    workload_free(&w);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("figures/sign_costs");
    TCase *numbers = tcase_create("numbers");
    tcase_add_loop_test(numbers, hits_are_the_oracles, 0, TIMED_WORKLOADS);
    tcase_add_loop_test(numbers, perturbed_hits_are_those_of_moved_queries, 0,
                        TIMED_WORKLOADS);
    tcase_add_loop_test(numbers, all_arithmetics_are_timed_on_all_queries, 0,
                        TIMED_WORKLOADS);
    suite_add_tcase(s, numbers);
    return s;
}
