// Queries on and beside the boundary between a hit and a miss: contacts with
// each coordinate a few units in the last place off, and axes and coordinates
// of any magnitude.
#include "support/judge.h"

typedef query maker(generator *random, query_kind kind);

/// Judge `count` queries of each kind by the oracle.
static void judge_all(maker *make, long count, uint64_t stream)
{
    generator random = generator_new(stream);
    truth known;
    truth_init(&known);
    for (int kind = 0; kind < KINDS; kind++)
        for (long i = 0; i < count; i++) {
            query q = make(&random, (query_kind)kind);
            truth_find(&q, &known);
            expect_truth(&q, &known);
        }
    truth_clear(&known);
}

START_TEST(elements_anywhere)
{
    judge_all(query_soup, cases(5000), 1);
}
END_TEST

START_TEST(elements_that_touch)
{
    judge_all(query_touching, cases(10000), 2);
}
END_TEST

START_TEST(flat_cloth_on_a_slant)
{
    judge_all(query_tilted, cases(10000), 3);
}
END_TEST

START_TEST(elements_at_rest)
{
    judge_all(query_resting, cases(10000), 4);
}
END_TEST

START_TEST(parallel_motion)
{
    judge_all(query_parallel, cases(10000), 5);
}
END_TEST

START_TEST(collapsed_elements)
{
    judge_all(query_collapsed, cases(5000), 6);
}
END_TEST

/// A lattice query three times in ten: of those every second one touches.
static query lattice_or_any(generator *random, query_kind kind)
{
    return below(random, 10) < 3 ? query_lattice(random, kind, 3)
                                 : query_any(random, kind);
}

static query nudged(generator *random, query_kind kind)
{
    query q = lattice_or_any(random, kind);
    query_nudge(random, &q, 2);
    return q;
}

START_TEST(some_units_in_the_last_place_off)
{
    judge_all(nudged, cases(40000), 7);
}
END_TEST

START_TEST(magnitudes_from_least_to_largest)
{
    judge_all(query_extreme, cases(10000), 8);
}
END_TEST

/// Scaled within the range where no bit of a coordinate is lost.
static query scaled(generator *random, query_kind kind)
{
    query q = lattice_or_any(random, kind);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, below(random, 601) - 300);
    return q;
}

START_TEST(axes_of_different_scales)
{
    judge_all(scaled, cases(10000), 9);
}
END_TEST

Suite *suite(void)
{
    Suite *neighbours = suite_create("neighbours");
    TCase *queries = tcase_create("queries");
    tcase_add_test(queries, elements_anywhere);
    tcase_add_test(queries, elements_that_touch);
    tcase_add_test(queries, flat_cloth_on_a_slant);
    tcase_add_test(queries, elements_at_rest);
    tcase_add_test(queries, parallel_motion);
    tcase_add_test(queries, collapsed_elements);
    tcase_add_test(queries, some_units_in_the_last_place_off);
    tcase_add_test(queries, magnitudes_from_least_to_largest);
    tcase_add_test(queries, axes_of_different_scales);
    suite_add_tcase(neighbours, queries);
    return neighbours;
}
