#include "query/narrow_phase.h"

#include "query/query.h"
#include "support/environments.h"
#include "support/rational.h"
#include "support/scenes.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>
#include <signal.h>
#include <stdbool.h>

static const tf_kind kinds[KINDS] = {TF_POINT_EDGE, TF_POINT_TRIANGLE,
                                     TF_EDGE_EDGE};

// One query -------------------------------------------------------------------

static tf_kind tried_kind;

static tf_status ask_reference(const tf_arithmetic *arithmetic,
                               const tf_motion *motion, const int vertex[],
                               tf_contact *contact)
{
    tf_queries one = {
        .kind = tried_kind, .motion = motion, .count = 1, .vertices = vertex};
    return tf_reference.decide(NULL, arithmetic, &one,
                               contact ? &contact->verdict : NULL,
                               &(size_t){0});
}

static void use(query_kind kind)
{
    tried_kind = kinds[kind];
    statuses_use(kind, ask_reference);
}

static void use_point_edge(void)
{
    use(POINT_EDGE);
}

static void use_point_triangle(void)
{
    use(POINT_TRIANGLE);
}

static void use_edge_edge(void)
{
    use(EDGE_EDGE);
}

// Many queries ----------------------------------------------------------------

enum {
    VERTICES = 40,
    QUERIES = 500
};

/// A lattice scene, dense enough for hits and misses.
static void fill(generator *random, double start[], double end[])
{
    for (int i = 0; i < VERTICES * TF_AXES; i++) {
        start[i] = below(random, 4);
        end[i] = below(random, 4);
    }
}

static bool is_among(int count, const int list[], int one)
{
    for (int i = 0; i < count; i++)
        if (list[i] == one)
            return true;
    return false;
}

/// Different indices of vertices.
static void choose(generator *random, int count, int vertex[])
{
    for (int i = 0; i < count; i++)
        do
            vertex[i] = below(random, VERTICES);
        while (is_among(i, vertex, vertex[i]));
}

static tf_verdict decide_one(query_kind kind, const tf_motion *motion,
                             const int vertex[])
{
    query shape = query_new(kind);
    tf_contact contact;
    ck_assert_int_eq(tf_query_motion(&oracle_arithmetic, shape.axes, motion,
                                     shape.vertices, vertex, shape.others,
                                     vertex + shape.vertices, &contact),
                     TF_OK);
    return contact.verdict;
}

START_TEST(a_batch_has_the_verdicts_of_single_queries)
{
    generator random = generator_new((uint64_t)_i);
    double start[VERTICES * TF_AXES], end[VERTICES * TF_AXES];
    fill(&random, start, end);
    tf_motion motion = {.axes = _i == POINT_EDGE ? 2 : 3,
                        .vertices = VERTICES,
                        .start = start,
                        .end = end};
    int size = _i == POINT_EDGE ? 3 : 4, vertex[QUERIES * QUERY_VERTICES];
    for (int i = 0; i < QUERIES; i++)
        choose(&random, size, vertex + size * i);
    tf_queries queries = {.kind = kinds[_i],
                          .motion = &motion,
                          .count = QUERIES,
                          .vertices = vertex};
    tf_verdict verdict[QUERIES + 1];
    verdict[QUERIES] = TF_UNDECIDED;
    size_t separated = 0;
    ck_assert_int_eq(tf_reference.decide(NULL, &oracle_arithmetic, &queries,
                                         verdict, &separated),
                     TF_OK);
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
        ck_assert_int_eq(
            verdict[i], decide_one((query_kind)_i, &motion, vertex + size * i));
        hits += verdict[i] == TF_HIT;
    }
    ck_assert_int_eq(verdict[QUERIES], TF_UNDECIDED);
    ck_assert_uint_gt(separated, 0);
    ck_assert_uint_le(separated, (size_t)(QUERIES - hits));
    ck_assert(20 * hits > QUERIES && 20 * (QUERIES - hits) > QUERIES);
}
END_TEST

/// Three queries about one edge, of which the second is as given.
static tf_status decide_three(const double start[], int second,
                              tf_verdict verdict[3])
{
    int vertex[] = {0, 1, 2, second, 1, 2, 0, 1, 2};
    tf_motion motion = {.axes = 2, .vertices = 4, .start = start, .end = start};
    tf_queries queries = {.kind = TF_POINT_EDGE,
                          .motion = &motion,
                          .count = 3,
                          .vertices = vertex};
    return tf_reference.decide(NULL, &oracle_arithmetic, &queries, verdict,
                               &(size_t){0});
}

START_TEST(a_bad_query_fails_the_batch)
{
    double x[] = {0, 0, -1, 0, 1, 0, 5, 5};
    tf_verdict verdict[3];
    ck_assert_int_eq(decide_three(x, 3, verdict), TF_OK);
    ck_assert_int_eq(verdict[0], TF_HIT);
    ck_assert_int_eq(verdict[1], TF_APART);
    ck_assert_int_eq(verdict[2], TF_HIT);
    ck_assert_int_eq(decide_three(x, 4, verdict), TF_BAD_INDEX);
    ck_assert_int_eq(decide_three(x, 2, verdict), TF_BAD_INDEX);
    x[6] = NAN;
    ck_assert_int_eq(decide_three(x, 3, verdict), TF_NOT_FINITE);
    ck_assert_int_eq(decide_three(x, 4, verdict), TF_BAD_INDEX);
}
END_TEST

START_TEST(an_empty_batch_is_accepted)
{
    tf_queries none = {.kind = TF_EDGE_EDGE};
    ck_assert_int_eq(tf_reference.decide(NULL, &oracle_arithmetic, &none, NULL,
                                         &(size_t){0}),
                     TF_OK);
}
END_TEST

START_TEST(an_empty_batch_is_accepted_in_a_broken_environment)
{
    environment_break(_i);
    tf_queries none = {.kind = TF_EDGE_EDGE};
    size_t separated = 0;
    tf_status status =
        tf_reference.decide(NULL, &oracle_arithmetic, &none, NULL, &separated);
    environment_restore();
    ck_assert_int_eq(status, TF_OK);
}
END_TEST

START_TEST(an_unknown_kind_is_refused)
{
    static const int unknown[] = {TF_NO_KIND, TF_EDGE_EDGE + 1, -1};
    tf_queries queries = {.kind = (tf_kind)unknown[_i]};
    ck_assert_int_eq(tf_reference.decide(NULL, &oracle_arithmetic, &queries,
                                         NULL, &(size_t){0}),
                     TF_BAD_OPTION);
}
END_TEST

START_TEST(missing_queries_or_room_break_the_contract)
{
    static const double x[12] = {0};
    static const int vertices[] = {0, 1, 2, 3};
    tf_motion motion = {.axes = 3, .vertices = 4, .start = x, .end = x};
    tf_queries one = {TF_EDGE_EDGE, &motion, 1, vertices};
    tf_queries nowhere = {TF_EDGE_EDGE, &motion, 1, NULL};
    tf_verdict verdict;
    switch (_i) {
    case 0:
        tf_reference.decide(NULL, NULL, &one, &verdict, &(size_t){0});
        break;
    case 1:
        tf_reference.decide(NULL, &oracle_arithmetic, NULL, &verdict,
                            &(size_t){0});
        break;
    case 2:
        tf_reference.decide(NULL, &oracle_arithmetic, &nowhere, &verdict,
                            &(size_t){0});
        break;
    case 3:
        tf_reference.decide(NULL, &oracle_arithmetic, &one, NULL, &(size_t){0});
        break;
    default:
        tf_reference.decide(NULL, &oracle_arithmetic, &one, &verdict, NULL);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/narrow_phase");
    TCase *many = tcase_create("many queries");
    tcase_add_loop_test(many, a_batch_has_the_verdicts_of_single_queries, 0,
                        KINDS);
    tcase_add_test(many, a_bad_query_fails_the_batch);
    tcase_add_test(many, an_empty_batch_is_accepted);
    tcase_add_loop_test(many,
                        an_empty_batch_is_accepted_in_a_broken_environment, 0,
                        environments());
    tcase_add_loop_test(many, an_unknown_kind_is_refused, 0, 3);
    tcase_add_loop_test_raise_signal(
        many, missing_queries_or_room_break_the_contract, SIGABRT, 0, 5);
    suite_add_tcase(suite, many);
    suite_add_tcase(suite, statuses_case("point-edge", use_point_edge));
    suite_add_tcase(suite, statuses_case("point-triangle", use_point_triangle));
    suite_add_tcase(suite, statuses_case("edge-edge", use_edge_edge));
    return suite;
}
