// Queries on and beside the boundary between a hit and a miss: contacts with
// each coordinate a few units in the last place off, and axes and coordinates
// of any magnitude.
#include "support/judge.h"

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

/// Scaled within the range where no bit of a coordinate is lost.
static query scaled(generator *random, query_kind kind)
{
    query q = lattice_or_any(random, kind);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, below(random, 601) - 300);
    return q;
}

/// Who makes queries, and how many of each kind.
static const struct {
    query (*make)(generator *random, query_kind kind);
    long count;
} makers[] = {
    {query_soup, 5000},     {query_touching, 10000}, {query_tilted, 10000},
    {query_resting, 10000}, {query_parallel, 10000}, {query_collapsed, 5000},
    {nudged, 40000},        {query_extreme, 10000},  {scaled, 10000},
};

START_TEST(nearby_queries_are_answered_as_the_oracle_does)
{
    generator random = generator_new((uint64_t)_i + 1);
    truth known;
    truth_init(&known);
    for (int kind = 0; kind < KINDS; kind++)
        for (long i = 0; i < cases(makers[_i].count); i++) {
            query q = makers[_i].make(&random, (query_kind)kind);
            truth_find(&q, &known);
            expect_truth(&q, &known);
        }
    truth_clear(&known);
}
END_TEST

Suite *suite(void)
{
    Suite *neighbours = suite_create("neighbours");
    TCase *queries = tcase_create("queries");
    tcase_add_loop_test(queries, nearby_queries_are_answered_as_the_oracle_does,
                        0, sizeof makers / sizeof *makers);
    suite_add_tcase(neighbours, queries);
    return neighbours;
}
