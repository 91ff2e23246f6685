// The vector narrow phase, against the reference.
#include "fast/vectorized.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "query/apart.h"
#include "query/query.h"
#include "support/environments.h"
#include "support/query_batch.h"
#include "support/rational.h"
#include "support/statuses.h"
#include "support/support.h"

#include <limits.h>
#include <math.h>
#include <signal.h>
#include <string.h>

static const tf_arithmetic *const arithmetics[] = {&tf_exact, &tf_perturbed,
                                                   &tf_clamped, &tf_published};

enum {
    ARITHMETICS = sizeof arithmetics / sizeof *arithmetics,
    BATCH = 500
};

static query_kind kind_of(int i)
{
    return i % 2 ? EDGE_EDGE : POINT_TRIANGLE;
}

// Verdicts --------------------------------------------------------------------

/// Expects that no query of a batch was found.
static void expect_none(const batch *b, size_t found,
                        const tf_arithmetic *arithmetic, const char *name)
{
    if (found == b->queries.count)
        return;
    query q = batch_query(b, found);
    ck_abort_msg("%s, %s, query %zu of %zu, seed %llu, %s\n%s", name,
                 tf_arithmetic_name(arithmetic), found, b->queries.count,
                 (unsigned long long)seed(), query_name(&q), query_text(&q));
}

static void compare_batch(batch *b, const tf_arithmetic *arithmetic,
                          const char *name)
{
    expect_none(b, batch_different(b, arithmetic), arithmetic, name);
}

START_TEST(verdicts_are_those_of_the_reference)
{
    const family *source = &families[_i / 2];
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    for (long i = cases(5000); i > 0; i -= BATCH) {
        batch_fill(&b, &random, source, kind_of(_i), BATCH);
        for (int k = 0; k < ARITHMETICS; k++)
            compare_batch(&b, arithmetics[k], source->name);
        expect_none(&b, batch_uncertain(&b), &tf_certain, source->name);
    }
    batch_free(&b);
}
END_TEST

/// How many of a family's queries tf_certain leaves undecided, in percent.
static double percent_left(int number, query_kind kind)
{
    generator random = generator_new((uint64_t)number);
    batch b = batch_new(BATCH);
    size_t separated = 0, left = 0;
    batch_fill(&b, &random, &families[number], kind, BATCH);
    b.queries.motion = &b.motion;
    ck_assert_int_eq(tf_vectorized.decide(NULL, &tf_certain, &b.queries,
                                          b.verdict[0], &separated),
                     TF_OK);
    for (size_t i = 0; i < BATCH; i++)
        left += b.verdict[0][i] == TF_UNDECIDED;
    batch_free(&b);
    return 100.0 * (double)left / BATCH;
}

static int family_named(const char *name)
{
    for (int i = 0; i < FAMILIES; i++)
        if (strcmp(families[i].name, name) == 0)
            return i;
    ck_abort_msg("no family %s", name);
}

// What meets is left, about a third of what lies in a small flat grid.
START_TEST(few_flat_queries_are_left_undecided)
{
    int flat = family_named("flat and turned");
    ck_assert_double_lt(percent_left(flat, POINT_TRIANGLE), 25);
    ck_assert_double_lt(percent_left(flat, EDGE_EDGE), 40);
    ck_assert_double_lt(
        percent_left(family_named("flat at rest"), POINT_TRIANGLE), 25);
}
END_TEST

START_TEST(integers_are_decided_by_the_reference)
{
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[2], kind_of(_i), BATCH);
    compare_batch(&b, &tf_integer64, "lattice");
    compare_batch(&b, &tf_integer128, "lattice");
    b.start[100] = 0.5;
    size_t separated = 0;
    ck_assert_int_eq(tf_vectorized.decide(NULL, &tf_integer128, &b.queries,
                                          b.verdict[0], &separated),
                     TF_OUT_OF_RANGE);
    batch_free(&b);
}
END_TEST

START_TEST(any_number_of_queries_can_be_decided)
{
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(200);
    batch_fill(&b, &random, &families[2], kind_of(_i), 200);
    for (size_t count = 0; count <= 200; count++) {
        b.queries.count = count;
        b.verdict[1][count] = (tf_verdict)42;
        compare_batch(&b, &tf_exact, "lattice");
        ck_assert_int_eq(b.verdict[1][count], 42);
    }
    batch_free(&b);
}
END_TEST

START_TEST(measuring_changes_no_verdict)
{
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    static double clearance[2 * BATCH];
    for (int k = 0; k < ARITHMETICS; k++) {
        size_t count = 1 + (size_t)below(&random, BATCH), separated[2] = {0};
        batch_fill(&b, &random, &families[_i / 2], kind_of(_i), count);
        for (int i = 0; i < 2 * BATCH; i++)
            clearance[i] = -42;
        ck_assert_int_eq(tf_vectorized.decide(NULL, arithmetics[k], &b.queries,
                                              b.verdict[0], &separated[0]),
                         TF_OK);
        ck_assert_int_eq(tf_vectorized.measure(NULL, arithmetics[k], &b.queries,
                                               b.verdict[1], &separated[1],
                                               clearance),
                         TF_OK);
        ck_assert_mem_eq(b.verdict[0], b.verdict[1],
                         count * sizeof *b.verdict[0]);
        ck_assert_uint_eq(separated[0], separated[1]);
        for (size_t i = 0; i < 2 * BATCH; i++)
            ck_assert(i < count ? clearance[i] >= 0 : clearance[i] == -42);
    }
    batch_free(&b);
}
END_TEST

START_TEST(what_the_reference_decides_has_no_clearance)
{
    generator random = generator_new(5);
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[2], kind_of(_i), BATCH);
    static double clearance[BATCH];
    clearance[0] = clearance[BATCH - 1] = 42;
    size_t separated = 0;
    ck_assert_int_eq(tf_vectorized.measure(NULL, &tf_integer64, &b.queries,
                                           b.verdict[0], &separated, clearance),
                     TF_OK);
    for (int i = 0; i < BATCH; i++)
        ck_assert_double_eq(clearance[i], 0);
    ck_assert(!tf_reference.measure);
    batch_free(&b);
}
END_TEST

START_TEST(the_plane_is_left_to_the_reference)
{
    generator random = generator_new(3);
    double start[80], end[80];
    int vertex[300];
    for (int i = 0; i < 80; i++) {
        start[i] = below(&random, 4);
        end[i] = below(&random, 4);
    }
    for (int i = 0; i < 300; i += 3) {
        int corner = below(&random, 20), step = 1 + below(&random, 19);
        vertex[i] = below(&random, 20);
        vertex[i + 1] = 20 + corner;
        vertex[i + 2] = 20 + (corner + step) % 20;
    }
    tf_motion motion = {2, 40, start, end};
    tf_queries queries = {TF_POINT_EDGE, &motion, 100, vertex};
    tf_verdict verdict[2][100];
    size_t separated[2] = {0};
    ck_assert_int_eq(tf_vectorized.decide(NULL, &tf_exact, &queries, verdict[0],
                                          &separated[0]),
                     TF_OK);
    tf_reference.decide(NULL, &tf_exact, &queries, verdict[1], &separated[1]);
    ck_assert_mem_eq(verdict[0], verdict[1], sizeof verdict[0]);
    ck_assert_uint_eq(separated[0], separated[1]);
}
END_TEST

// Statuses --------------------------------------------------------------------

/// What is wrong with two queries of many.
typedef struct damage {
    size_t query[2];
    int what[2]; ///< 0 nothing, 1 to 4 an index, 5 to 28 a coordinate
    double number;
    int index;
} damage;

static void inflict(batch *b, const damage *d)
{
    for (int i = 0; i < 2; i++) {
        size_t place = d->query[i];
        int what = d->what[i];
        if (what >= 5)
            (what >= 17 ? b->end
                        : b->start)[12 * place + (size_t)(what - 5) % 12] =
                d->number;
        else if (what >= 1)
            b->vertex[4 * place + (size_t)(what - 1)] =
                d->index == 0 ? b->vertex[4 * place + (size_t)(what % 4)]
                              : d->index;
    }
}

static damage any_damage(generator *random, size_t count)
{
    static const double number[] = {NAN, INFINITY, -INFINITY};
    static const int index[] = {-1, INT_MIN, INT_MAX, 4 * BATCH, 0};
    damage d = {.number = number[below(random, 3)],
                .index = index[below(random, 5)]};
    for (int i = 0; i < 2; i++) {
        d.query[i] = (size_t)below(random, (int)count);
        d.what[i] = below(random, 2) ? below(random, 29) : 0;
    }
    return d;
}

/// Both narrow phases, with verdicts that show what is left unset.
static tf_status try_both(batch *b, const tf_arithmetic *arithmetic)
{
    size_t bytes = b->queries.count * sizeof(tf_verdict), separated[2] = {0};
    memset(b->verdict[0], 42, bytes);
    memset(b->verdict[1], 42, bytes);
    tf_status expected = tf_reference.decide(NULL, arithmetic, &b->queries,
                                             b->verdict[0], &separated[0]);
    tf_status status = tf_vectorized.decide(NULL, arithmetic, &b->queries,
                                            b->verdict[1], &separated[1]);
    ck_assert_int_eq(status, expected);
    ck_assert_uint_eq(separated[0], separated[1]);
    ck_assert_mem_eq(b->verdict[0], b->verdict[1], bytes);
    return status;
}

START_TEST(the_first_bad_query_has_its_status)
{
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    int statuses[TF_BAD_ENVIRONMENT + 1] = {0};
    for (long i = cases_at_least(100, 1000); i > 0; i--) {
        size_t count = 1 + (size_t)below(&random, 150);
        batch_fill(&b, &random, &families[below(&random, FAMILIES)],
                   kind_of(_i), count);
        b.queries.motion = &b.motion;
        damage d = any_damage(&random, count);
        inflict(&b, &d);
        statuses[try_both(&b, arithmetics[below(&random, ARITHMETICS)])]++;
    }
    ck_assert_int_gt(statuses[TF_OK], 0);
    ck_assert_int_gt(statuses[TF_NOT_FINITE], 0);
    ck_assert_int_gt(statuses[TF_BAD_INDEX], 0);
    batch_free(&b);
}
END_TEST

START_TEST(a_broken_environment_is_reported)
{
    generator random = generator_new(4);
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[0], EDGE_EDGE, BATCH);
    b.queries.motion = &b.motion;
    size_t separated = 0;
    environment_break(_i);
    tf_status status = tf_vectorized.decide(NULL, &tf_exact, &b.queries,
                                            b.verdict[0], &separated);
    environment_restore();
    ck_assert_int_eq(status, TF_BAD_ENVIRONMENT);
    batch_free(&b);
}
END_TEST

/// One query at a time, exactly.
static tf_kind tried_kind;

static tf_status decide_one(const tf_arithmetic *arithmetic,
                            const tf_motion *motion, const int vertex[],
                            tf_contact *contact)
{
    tf_queries one = {tried_kind, motion, 1, vertex};
    return tf_vectorized.decide(
        NULL, arithmetic == &oracle_arithmetic ? &tf_exact : arithmetic, &one,
        contact ? &contact->verdict : NULL, &(size_t){0});
}

static void use_point_triangle(void)
{
    tried_kind = TF_POINT_TRIANGLE;
    statuses_use(POINT_TRIANGLE, decide_one);
}

static void use_edge_edge(void)
{
    tried_kind = TF_EDGE_EDGE;
    statuses_use(EDGE_EDGE, decide_one);
}

START_TEST(no_queries_are_decided_at_once)
{
    tf_queries none = {.kind = TF_EDGE_EDGE};
    ck_assert_int_eq(
        tf_vectorized.decide(NULL, &tf_exact, &none, NULL, &(size_t){0}),
        TF_OK);
}
END_TEST

START_TEST(an_unknown_kind_is_refused)
{
    static const double x[12] = {0};
    static const int vertices[] = {0, 1, 2, 3};
    tf_motion motion = {.axes = 3, .vertices = 4, .start = x, .end = x};
    tf_queries unknown = {TF_NO_KIND, &motion, 1, vertices};
    tf_verdict verdict;
    ck_assert_int_eq(
        tf_vectorized.decide(NULL, &tf_exact, &unknown, &verdict, &(size_t){0}),
        TF_BAD_OPTION);
}
END_TEST

START_TEST(missing_queries_or_verdicts_break_the_contract)
{
    static const double x[12] = {0};
    static const int vertices[] = {0, 1, 2, 3};
    tf_motion motion = {.axes = 3, .vertices = 4, .start = x, .end = x};
    tf_queries one = {TF_EDGE_EDGE, &motion, 1, vertices};
    tf_queries nowhere = {TF_EDGE_EDGE, &motion, 1, NULL};
    tf_verdict verdict;
    size_t separated = 0;
    const struct {
        const tf_queries *queries;
        tf_verdict *verdict;
        size_t *separated;
    } missing[] = {{NULL, &verdict, &separated},
                   {&nowhere, &verdict, &separated},
                   {&one, NULL, &separated},
                   {&one, &verdict, NULL}};
    exit_on_broken_contract();
    tf_vectorized.decide(NULL, &tf_exact, missing[_i].queries,
                         missing[_i].verdict, missing[_i].separated);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/vectorized");
    TCase *c = tcase_create("vector");
    tcase_add_loop_test(c, verdicts_are_those_of_the_reference, 0,
                        2 * FAMILIES);
    tcase_add_test(c, few_flat_queries_are_left_undecided);
    tcase_add_loop_test(c, integers_are_decided_by_the_reference, 0, 2);
    tcase_add_loop_test(c, any_number_of_queries_can_be_decided, 0, 2);
    tcase_add_loop_test(c, measuring_changes_no_verdict, 0, 2 * FAMILIES);
    tcase_add_loop_test(c, what_the_reference_decides_has_no_clearance, 0, 2);
    tcase_add_test(c, the_plane_is_left_to_the_reference);
    tcase_add_loop_test(c, the_first_bad_query_has_its_status, 0, 2);
    tcase_add_loop_test(c, a_broken_environment_is_reported, 0, environments());
    tcase_add_test(c, no_queries_are_decided_at_once);
    tcase_add_test(c, an_unknown_kind_is_refused);
    tcase_add_loop_exit_test(c, missing_queries_or_verdicts_break_the_contract,
                             BROKEN_CONTRACT, 0, 4);
    suite_add_tcase(suite, c);
    suite_add_tcase(suite, statuses_case("point-triangle", use_point_triangle));
    suite_add_tcase(suite, statuses_case("edge-edge", use_edge_edge));
    return suite;
}
