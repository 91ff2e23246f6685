// The perturbed arithmetic: the answers are those of elements whose events were
// moved by explicit tiny numbers, and those of exact signs where none is zero.
#include "arithmetic/perturbed.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "intersect/pair.h"
#include "query/query.h"
#include "support/judge.h"
#include "support/moved_simplices.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/// Number the vertices at random; those of an element increase.
static void mix_vertices(generator *random, query *q)
{
    int next[2] = {0, q->vertices};
    for (int v = 0; v < q->vertices + q->others; v++) {
        int left[2] = {q->vertices - next[0],
                       q->vertices + q->others - next[1]};
        int side = below(random, left[0] + left[1]) >= left[0];
        tf_worldline_set_vertex(&q->vertex[next[side]++], v);
    }
}

// Moved elements --------------------------------------------------------------

static bool encloses(const tf_contact *contact, const mpq_t toi)
{
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    mpq_set_d(lo, contact->toi_lo);
    mpq_set_d(hi, contact->toi_hi);
    bool within = mpq_cmp(lo, toi) <= 0 && mpq_cmp(toi, hi) <= 0;
    mpq_clears(lo, hi, NULL);
    return within && contact->toi_hi - contact->toi_lo <= 0x1p-50;
}

/// What is wrong with the perturbed answer; NULL if nothing is.
static const char *moved_fault(const query *q, bool *hit)
{
    mpq_t toi;
    mpq_init(toi);
    *hit = moved_meet(q->axes, q->vertices, q->vertex, q->others,
                      query_const_others(q), toi);
    tf_contact contact = ask(&tf_perturbed, q);
    const char *fault = NULL;
    if (contact.verdict != (*hit ? TF_HIT : TF_APART))
        fault = "not the verdict of the moved elements";
    else if (contact.classification != (*hit ? TF_GENERIC : TF_UNCLASSIFIED))
        fault = "a contact that is not generic";
    else if (*hit && !encloses(&contact, toi))
        fault = "not the time of the moved elements";
    mpq_clear(toi);
    return fault;
}

START_TEST(lattice_queries_are_answered_as_if_moved)
{
    generator random = generator_new((uint64_t)_i);
    long hits = 0, lost = 0, all = cases(20000);
    for (long i = 0; i < all; i++) {
        query q = query_lattice(&random, (query_kind)_i, 2 + below(&random, 3));
        mix_vertices(&random, &q);
        bool hit;
        expect_no_fault(moved_fault(&q, &hit), &q);
        hits += hit;
        lost += !hit && ask(&tf_exact, &q).verdict == TF_HIT;
    }
    // Both answers, and contacts that the motion undoes, are common.
    ck_assert_int_gt(hits, all / 20);
    ck_assert_int_gt(all - hits, all / 20);
    ck_assert_int_gt(lost, all / 50);
}
END_TEST

/// The place of an event among those of S and then R.
static int place_in(const moved_pair *pair, const tf_event *event)
{
    for (int i = 0; i < pair->s.count; i++)
        if (pair->s.event[i] == event)
            return i;
    int place = 0;
    while (pair->r.event[place] != event)
        place++;
    return pair->s.count + place;
}

/// Whether all signs of a pair are those of the moved events, also where no
/// verdict depends on them.
static bool signs_are_moved(const tf_pair *pair, const moved_pair *moved)
{
    int factor = 0;
    for (int i = 0; i < pair->count; i++) {
        tf_differences d;
        tf_pair_differences(pair, i, &d);
        int sign = (int)tf_perturbed.sign(&d) * (i % 2 == 0 ? 1 : -1) *
                   (i < pair->start_count ? 1 : -1);
        int product = sign * moved_sign(moved, place_in(moved, pair->event[i]));
        if (product == 0 || (factor != 0 && product != factor))
            return false;
        factor = product;
    }
    return true;
}

START_TEST(lattice_signs_are_those_of_moved_events)
{
    generator random = generator_new((uint64_t)(70 + _i));
    for (long i = 0; i < cases(5000); i++) {
        query q = query_lattice(&random, (query_kind)_i, 2 + below(&random, 3));
        mix_vertices(&random, &q);
        tf_simplex s[TF_VERTICES], r[TF_VERTICES];
        tf_sweep(q.vertices, q.vertex, s);
        tf_sweep(q.others, query_const_others(&q), r);
        int a = below(&random, q.vertices), b = below(&random, q.others);
        tf_pair pair = tf_pair_of(&s[a], &r[b], q.axes);
        moved_pair moved = {
            .axes = q.axes,
            .timed = true,
            .s = oracle_step(q.vertices, q.vertex, s[a].pivot),
            .r = oracle_step(q.others, query_const_others(&q), r[b].pivot)};
        if (!signs_are_moved(&pair, &moved))
            expect_no_fault("not the signs of moved events", &q);
    }
}
END_TEST

/// The determinants of the test above against the oracle, on numbers written
/// out in full.
START_TEST(moved_pairs_meet_as_the_oracle_says)
{
    enum {
        BITS = 14 // a determinant of these has a sum of factors below 2^13
    };
    generator random = generator_new(10);
    mpq_t toi, true_toi, difference;
    mpq_inits(toi, true_toi, difference, NULL);
    long hits = 0, all = cases(300);
    for (long i = 0; i < all; i++) {
        query q = query_lattice(&random, (query_kind)(i % KINDS), 3);
        mix_vertices(&random, &q);
        moved_pair pair = {
            .axes = q.axes,
            .timed = true,
            .s = oracle_step(q.vertices, q.vertex, below(&random, q.vertices)),
            .r = oracle_step(q.others, query_const_others(&q),
                             below(&random, q.others))};
        bool hit = moved_pair_meets(&pair, toi);
        bool true_hit = moved_pair_meets_by_oracle(&pair, BITS, true_toi);
        if (hit != true_hit)
            expect_no_fault("the oracle contradicts the determinants", &q);
        hits += hit;
        if (!hit)
            continue;
        mpq_sub(difference, toi, true_toi);
        if (fabs(mpq_get_d(difference)) > 0x1p-8)
            expect_no_fault("the oracle has another time", &q);
    }
    // About one in eleven is a hit: a few cases may have none.
    if (all >= 300)
        ck_assert_int_gt(hits, all / 30);
    mpq_clears(toi, true_toi, difference, NULL);
}
END_TEST

// Exact signs -----------------------------------------------------------------

// Whatever is found for moved elements is found in the limit too, where
// touching counts; and nothing moves far enough to change a sign that is not
// zero.
START_TEST(answers_are_exact_but_for_touching)
{
    generator random = generator_new((uint64_t)(20 + _i));
    long generic = 0;
    for (long i = 0; i < cases(40000); i++) {
        query q = i % 4 == 0   ? query_lattice(&random, (query_kind)_i, 9)
                  : i % 4 == 1 ? query_extreme(&random, (query_kind)_i)
                               : query_any(&random, (query_kind)_i);
        mix_vertices(&random, &q);
        expect_no_fault(perturbed_fault(&q), &q);
        tf_contact exact = ask(&tf_exact, &q);
        generic +=
            exact.verdict == TF_HIT && exact.classification == TF_GENERIC;
    }
    ck_assert_int_gt(generic, 0);
}
END_TEST

// Order -----------------------------------------------------------------------

/// The same two edges, the second first.
static query swap_edges(const query *q)
{
    query swapped = *q;
    for (int i = 0; i < QUERY_VERTICES; i++)
        swapped.vertex[i] = q->vertex[(i + 2) % QUERY_VERTICES];
    return swapped;
}

static bool same_time(const tf_contact *a, const tf_contact *b)
{
    return a->verdict == b->verdict && a->toi_lo == b->toi_lo &&
           a->toi_hi == b->toi_hi;
}

START_TEST(two_edges_may_be_swapped)
{
    generator random = generator_new(40);
    for (long i = 0; i < cases(20000); i++) {
        query q = query_lattice(&random, EDGE_EDGE, 3);
        mix_vertices(&random, &q);
        query swapped = swap_edges(&q);
        tf_contact a = ask(&tf_perturbed, &q);
        tf_contact b = ask(&tf_perturbed, &swapped);
        if (a.verdict != b.verdict || fabs(a.toi_lo - b.toi_lo) > 0x1p-50 ||
            fabs(a.toi_hi - b.toi_hi) > 0x1p-50)
            expect_no_fault("another answer for swapped edges", &q);
    }
}
END_TEST

/// Shuffle the vertices of both elements; order[i] is where vertex i was.
static query shuffle(generator *random, const query *q,
                     int order[QUERY_VERTICES], int *parity)
{
    query shuffled = *q;
    *parity = 1;
    for (int i = 0; i < QUERY_VERTICES; i++)
        order[i] = i;
    for (int i = q->vertices + q->others - 1; i > 0; i--) {
        int begin = i < q->vertices ? 0 : q->vertices;
        int other = begin + below(random, i - begin + 1);
        if (other == i)
            continue;
        tf_worldline moved = shuffled.vertex[i];
        shuffled.vertex[i] = shuffled.vertex[other];
        shuffled.vertex[other] = moved;
        int place = order[i];
        order[i] = order[other];
        order[other] = place;
        *parity = -*parity;
    }
    return shuffled;
}

static double barycentric_of(const query *q, const tf_contact *contact, int i)
{
    return i < q->vertices ? contact->barycentric[0][i]
                           : contact->barycentric[1][i - q->vertices];
}

START_TEST(vertices_may_come_in_any_order)
{
    generator random = generator_new((uint64_t)(50 + _i));
    for (long i = 0; i < cases(20000); i++) {
        query q = i % 2 ? query_lattice(&random, (query_kind)_i, 3)
                        : query_any(&random, (query_kind)_i);
        mix_vertices(&random, &q);
        int order[QUERY_VERTICES], parity;
        query shuffled = shuffle(&random, &q, order, &parity);
        const tf_arithmetic *arithmetic = i % 4 < 2 ? &tf_perturbed : &tf_exact;
        tf_contact a = ask(arithmetic, &q), b = ask(arithmetic, &shuffled);
        bool same = same_time(&a, &b) &&
                    b.normal_velocity == parity * a.normal_velocity;
        for (int k = 0; k < q.axes; k++)
            same &= b.normal[k] == parity * a.normal[k];
        for (int v = 0; v < q.vertices + q.others; v++)
            same &=
                barycentric_of(&q, &b, v) == barycentric_of(&q, &a, order[v]);
        if (!same)
            expect_no_fault("another answer for another order", &q);
    }
}
END_TEST

START_TEST(only_the_order_of_indices_counts)
{
    generator random = generator_new((uint64_t)(60 + _i));
    for (long i = 0; i < cases(5000); i++) {
        query q = query_lattice(&random, (query_kind)_i, 3);
        mix_vertices(&random, &q);
        query wide = q;
        for (int v = 0; v < q.vertices + q.others; v++)
            tf_worldline_set_vertex(&wide.vertex[v],
                                    INT_MAX - 3 + q.vertex[v].at[0].vertex);
        tf_contact a = ask(&tf_perturbed, &q), b = ask(&tf_perturbed, &wide);
        if (memcmp(&a, &b, sizeof a) != 0)
            expect_no_fault("another answer for larger indices", &q);
    }
}
END_TEST

START_TEST(indices_are_needed)
{
    query q = query_new((query_kind)_i);
    tf_contact contact;
    ck_assert_int_eq(tf_query(&tf_perturbed, q.axes, q.vertices, q.vertex,
                              q.others, query_const_others(&q), &contact),
                     TF_BAD_INDEX);
    query_number(&q);
    ck_assert_int_eq(tf_query(&tf_perturbed, q.axes, q.vertices, q.vertex,
                              q.others, query_const_others(&q), &contact),
                     TF_OK);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("perturbation");
    TCase *c = tcase_create("perturbation");
    tcase_add_loop_test(c, lattice_queries_are_answered_as_if_moved, 0, KINDS);
    tcase_add_loop_test(c, lattice_signs_are_those_of_moved_events, 0, KINDS);
    tcase_add_test(c, moved_pairs_meet_as_the_oracle_says);
    tcase_add_loop_test(c, answers_are_exact_but_for_touching, 0, KINDS);
    tcase_add_test(c, two_edges_may_be_swapped);
    tcase_add_loop_test(c, vertices_may_come_in_any_order, 0, KINDS);
    tcase_add_loop_test(c, only_the_order_of_indices_counts, 0, KINDS);
    tcase_add_loop_test(c, indices_are_needed, 0, KINDS);
    suite_add_tcase(s, c);
    return s;
}
