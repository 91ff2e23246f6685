// What is asked for less answers the same: the verdict alone, the time without
// the point, many queries at once, and the vertices in another order.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "intersect/cascade.h"
#include "query/edge_edge.h"
#include "query/narrow_phase.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"
#include "query/query.h"
#include "support/contacts.h"
#include "support/judge.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const tf_arithmetic *const arithmetics[] = {
    &tf_exact,     &tf_clamped,   &tf_published,
    &tf_perturbed, &tf_integer64, &tf_integer128,
};

enum {
    ARITHMETICS = sizeof arithmetics / sizeof *arithmetics,
    LOOPS = ARITHMETICS * KINDS
};

/// Of a loop over all arithmetics and kinds.
static const tf_arithmetic *arithmetic_of(int loop)
{
    return arithmetics[loop / KINDS];
}

static query_kind kind_of(int loop)
{
    return (query_kind)(loop % KINDS);
}

// Queries ---------------------------------------------------------------------

/// A query that the arithmetic holds: a lattice one, or any.
static query held_query(generator *random, const tf_arithmetic *arithmetic,
                        query_kind kind)
{
    int axes = kind == POINT_EDGE ? 2 : 3;
    if (tf_arithmetic_bits(arithmetic, axes) > 0 || below(random, 2))
        return query_lattice(random, kind, 2 + below(random, 4));
    query q = below(random, 8) ? query_any(random, kind)
                               : query_extreme(random, kind);
    if (below(random, 2))
        query_nudge(random, &q, 1);
    return q;
}

/// Give the vertices any of the first indices, and tell which.
static void mix_indices(generator *random, query *q, int index[])
{
    int left[SCENE_VERTICES];
    for (int i = 0; i < SCENE_VERTICES; i++)
        left[i] = i;
    for (int i = 0; i < q->vertices + q->others; i++) {
        int chosen = i + below(random, SCENE_VERTICES - i);
        index[i] = left[chosen];
        left[chosen] = left[i];
        tf_worldline_set_vertex(&q->vertex[i], index[i]);
    }
}

static void expect(bool good, const char *fault,
                   const tf_arithmetic *arithmetic, const query *q)
{
    if (good)
        return;
    char text[200];
    snprintf(text, sizeof text, "%s: %s", arithmetic->name, fault);
    expect_no_fault(text, q);
}

// One query, asked in several ways --------------------------------------------

static tf_contact ask_public(const tf_arithmetic *arithmetic, const query *q,
                             const scene *s)
{
    tf_motion motion = scene_motion(s);
    const int *v = s->index;
    tf_contact contact;
    tf_status status =
        q->axes == 2 ? tf_point_edge(arithmetic, &motion, v[0], v + 1, &contact)
        : q->vertices == 1
            ? tf_point_triangle(arithmetic, &motion, v[0], v + 1, &contact)
            : tf_edge_edge(arithmetic, &motion, v, v + 2, &contact);
    ck_assert_int_eq(status, TF_OK);
    return contact;
}

static tf_verdict ask_verdict(const tf_arithmetic *arithmetic, const query *q,
                              const scene *s)
{
    tf_motion motion = scene_motion(s);
    tf_verdict verdict;
    ck_assert_int_eq(tf_query_verdict(arithmetic, q->axes, &motion, q->vertices,
                                      s->index, q->others,
                                      s->index + q->vertices, &verdict,
                                      &(bool){false}),
                     TF_OK);
    return verdict;
}

START_TEST(the_verdict_alone_is_that_of_the_contact)
{
    const tf_arithmetic *arithmetic = arithmetic_of(_i);
    generator random = generator_new((uint64_t)_i);
    long hits = 0, all = cases(10000);
    for (long i = 0; i < all; i++) {
        query q = held_query(&random, arithmetic, kind_of(_i));
        int index[QUERY_VERTICES];
        mix_indices(&random, &q, index);
        scene s = scene_of(&q, index);
        tf_contact contact = ask(arithmetic, &q);
        tf_contact public = ask_public(arithmetic, &q, &s);
        tf_verdict verdict = ask_verdict(arithmetic, &q, &s);
        expect(verdict == contact.verdict, "another verdict alone", arithmetic,
               &q);
        expect(contacts_are_same(&public, &contact),
               "another contact of a scene", arithmetic, &q);
        hits += verdict == TF_HIT;
    }
    ck_assert_int_gt(20 * hits, all);
    ck_assert_int_gt(20 * (all - hits), all);
}
END_TEST

// Pairs of simplices ----------------------------------------------------------

static int by_index(const void *a, const void *b)
{
    return ((const tf_worldline *)a)->at[0].vertex -
           ((const tf_worldline *)b)->at[0].vertex;
}

/// Put the vertices of each element in the order of their indices.
static void sort(query *q)
{
    qsort(q->vertex, (size_t)q->vertices, sizeof *q->vertex, by_index);
    qsort(query_others(q), (size_t)q->others, sizeof *q->vertex, by_index);
}

static bool same_decision(const tf_intersection *a, const tf_intersection *b)
{
    return a->verdict == b->verdict && a->classification == b->classification &&
           a->unique == b->unique;
}

static bool same_times(const tf_intersection *a, const tf_intersection *b)
{
    return a->toi_lo == b->toi_lo && a->toi_hi == b->toi_hi;
}

static bool same_points(const tf_intersection *a, const tf_intersection *b)
{
    for (int i = 0; i < TF_PAIR_EVENTS; i++)
        if (a->barycentric[i] != b->barycentric[i])
            return false;
    return true;
}

/// What is wrong with a pair of simplices, asked for more and more; NULL if
/// nothing is.
static const char *detail_fault(const tf_arithmetic *arithmetic,
                                const tf_pair *pair)
{
    tf_intersection verdict = tf_intersect(arithmetic, pair, TF_ONLY_VERDICT);
    tf_intersection time = tf_intersect(arithmetic, pair, TF_WITH_TIME);
    tf_intersection point = tf_intersect(arithmetic, pair, TF_WITH_POINT);
    if (!same_decision(&verdict, &time) || !same_decision(&time, &point))
        return "another verdict or classification";
    if (verdict.verdict == TF_APART)
        return NULL;
    if (!same_times(&time, &point))
        return "another time";

    // Described afterwards, at once or in two steps.
    tf_intersection late = verdict;
    tf_intersection_describe(arithmetic, pair, TF_WITH_POINT, &late);
    tf_intersection_describe(arithmetic, pair, TF_WITH_TIME, &verdict);
    if (!same_decision(&late, &point) || !same_times(&late, &point) ||
        !same_points(&late, &point))
        return "another description";
    return same_times(&verdict, &point) ? NULL : "another described time";
}

START_TEST(more_detail_decides_nothing_else)
{
    const tf_arithmetic *arithmetic = arithmetic_of(_i);
    generator random = generator_new((uint64_t)(100 + _i));
    for (long i = 0; i < cases(5000); i++) {
        query q = held_query(&random, arithmetic, kind_of(_i));
        int index[QUERY_VERTICES];
        mix_indices(&random, &q, index);
        sort(&q);
        tf_simplex s[TF_VERTICES], r[TF_VERTICES];
        tf_sweep(q.vertices, q.vertex, s);
        tf_sweep(q.others, query_const_others(&q), r);
        for (int a = 0; a < q.vertices; a++)
            for (int b = 0; b < q.others; b++) {
                tf_pair pair = tf_pair_of(&s[a], &r[b], q.axes);
                const char *fault = detail_fault(arithmetic, &pair);
                expect(!fault, fault, arithmetic, &q);
            }
    }
}
END_TEST

// Many queries ----------------------------------------------------------------

enum {
    BATCH = 1000,
    BATCH_VERTICES = BATCH * SCENE_VERTICES
};

/// Many queries in one scene, each with vertices of its own.
typedef struct batch {
    int size; ///< vertices a query
    int vertex[BATCH * QUERY_VERTICES];
    double start[BATCH_VERTICES * TF_AXES], end[BATCH_VERTICES * TF_AXES];
} batch;

static void add(batch *all, int at, const query *q, const int index[])
{
    scene s = scene_of(q, index);
    int coordinates = SCENE_VERTICES * q->axes;
    size_t bytes = (size_t)coordinates * sizeof(double);
    memcpy(all->start + at * coordinates, s.start, bytes);
    memcpy(all->end + at * coordinates, s.end, bytes);
    for (int i = 0; i < all->size; i++)
        all->vertex[at * all->size + i] = at * SCENE_VERTICES + index[i];
}

static void decide(const tf_arithmetic *arithmetic, query_kind kind,
                   const batch *all, tf_verdict verdict[BATCH])
{
    static const tf_kind kinds[KINDS] = {TF_POINT_EDGE, TF_POINT_TRIANGLE,
                                         TF_EDGE_EDGE};
    tf_motion motion = {.axes = kind == POINT_EDGE ? 2 : 3,
                        .vertices = BATCH_VERTICES,
                        .start = all->start,
                        .end = all->end};
    tf_queries queries = {.kind = kinds[kind],
                          .motion = &motion,
                          .count = BATCH,
                          .vertices = all->vertex};
    ck_assert_int_eq(
        tf_reference.decide(NULL, arithmetic, &queries, verdict, &(size_t){0}),
        TF_OK);
}

START_TEST(many_queries_are_decided_as_each_alone)
{
    static batch all;
    static query q[BATCH];
    const tf_arithmetic *arithmetic = arithmetic_of(_i);
    generator random = generator_new((uint64_t)(200 + _i));
    all.size = kind_of(_i) == POINT_EDGE ? 3 : 4;
    for (int i = 0; i < BATCH; i++) {
        int index[QUERY_VERTICES];
        q[i] = held_query(&random, arithmetic, kind_of(_i));
        mix_indices(&random, &q[i], index);
        add(&all, i, &q[i], index);
    }
    tf_verdict verdict[BATCH];
    decide(arithmetic, kind_of(_i), &all, verdict);
    for (int i = 0; i < BATCH; i++)
        expect(verdict[i] == ask(arithmetic, &q[i]).verdict,
               "another verdict among many", arithmetic, &q[i]);
}
END_TEST

// Signs and values at once ----------------------------------------------------

/// The same arithmetic, which finds every sign and value by itself.
static tf_arithmetic one_by_one(const tf_arithmetic *arithmetic)
{
    tf_arithmetic alone = *arithmetic;
    alone.six = NULL;
    alone.six_signs = NULL;
    alone.six_estimates = NULL;
    alone.cross = NULL;
    return alone;
}

START_TEST(signs_found_at_once_are_those_found_one_by_one)
{
    const tf_arithmetic *arithmetic = arithmetic_of(_i);
    tf_arithmetic alone = one_by_one(arithmetic);
    generator random = generator_new((uint64_t)(400 + _i));
    for (long i = cases(10000); i > 0; i--) {
        query q = held_query(&random, arithmetic, kind_of(_i));
        int index[QUERY_VERTICES];
        mix_indices(&random, &q, index);
        tf_contact expected = ask(&alone, &q);
        tf_contact contact = ask(arithmetic, &q);
        expect(contacts_are_same(&contact, &expected),
               "another contact one by one", arithmetic, &q);
    }
}
END_TEST

// Other orders ----------------------------------------------------------------

/// Swap two vertices of an element of two or three.
static void swap(query *q, double barycentric[3], int begin, int i, int j)
{
    tf_worldline line = q->vertex[begin + i];
    q->vertex[begin + i] = q->vertex[begin + j];
    q->vertex[begin + j] = line;
    double own = barycentric[i];
    barycentric[i] = barycentric[j];
    barycentric[j] = own;
}

/// Swap two vertices of an element, and what the contact lists by vertices;
/// turn its normal.
static void swap_some(generator *random, query *q, tf_contact *contact)
{
    bool first = q->vertices > 1 && below(random, 2);
    int count = first ? q->vertices : q->others, i = below(random, count);
    swap(q, contact->barycentric[!first], first ? 0 : q->vertices, i,
         (i + 1 + below(random, count - 1)) % count);
    for (int k = 0; k < TF_AXES; k++)
        contact->normal[k] = 0.0 - contact->normal[k];
    contact->normal_velocity = 0.0 - contact->normal_velocity;
}

START_TEST(another_order_of_vertices_only_turns_the_normal)
{
    const tf_arithmetic *arithmetic = arithmetic_of(_i);
    generator random = generator_new((uint64_t)(300 + _i));
    for (long i = 0; i < cases(3000); i++) {
        query q = held_query(&random, arithmetic, kind_of(_i));
        int index[QUERY_VERTICES];
        mix_indices(&random, &q, index);
        tf_contact expected = ask(arithmetic, &q);
        for (int swaps = 0; swaps < 4; swaps++) {
            swap_some(&random, &q, &expected);
            tf_contact contact = ask(arithmetic, &q);
            expect(contacts_are_same(&contact, &expected),
                   "another contact when reordered", arithmetic, &q);
        }
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("agreement");
    TCase *tcase = tcase_create("agreement");
    tcase_add_loop_test(tcase, the_verdict_alone_is_that_of_the_contact, 0,
                        LOOPS);
    tcase_add_loop_test(tcase, signs_found_at_once_are_those_found_one_by_one,
                        0, LOOPS);
    tcase_add_loop_test(tcase, more_detail_decides_nothing_else, 0, LOOPS);
    tcase_add_loop_test(tcase, many_queries_are_decided_as_each_alone, 0,
                        LOOPS);
    tcase_add_loop_test(tcase, another_order_of_vertices_only_turns_the_normal,
                        0, LOOPS);
    suite_add_tcase(suite, tcase);
    return suite;
}
