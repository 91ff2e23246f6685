#include "intersect/separation.h"

#include "intersect/complementary.h"
#include "support/pairs.h"
#include "support/queries.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

// Pairs -----------------------------------------------------------------------

/// Whether on an axis each event of S has a larger coordinate (direction +1) or
/// a smaller one (-1) than each event of R of the same time.
static bool keeps_to_one_side(const tf_pair *pair, int axis, int direction)
{
    for (int i = 0; i < pair->count; i++)
        for (int j = 0; j < pair->count; j++) {
            const tf_event *s = pair->event[i], *r = pair->event[j];
            if (pair->operand[i] > 0 && pair->operand[j] < 0 && s->t == r->t &&
                !(direction * s->x[axis] > direction * r->x[axis]))
                return false;
        }
    return true;
}

static bool some_axis_separates(const tf_pair *pair)
{
    for (int k = 0; k < pair->axes; k++)
        if (keeps_to_one_side(pair, pair->axis[k], +1) ||
            keeps_to_one_side(pair, pair->axis[k], -1))
            return true;
    return false;
}

static bool expect_right(const own_pair *own)
{
    bool separated = tf_pair_separated(&own->pair);
    ck_assert_msg(separated == some_axis_separates(&own->pair),
                  "separated: %d:\n%s", separated, pair_text(own));
    const char *fault =
        separated ? intersection_fault(own, &tf_intersection_apart, true)
                  : NULL;
    ck_assert_msg(!fault, "%s:\n%s", fault, pair_text(own));
    return separated;
}

static void expect_both(long separated, long all)
{
    ck_assert_msg(20 * separated > all && 20 * (all - separated) > all,
                  "%ld of %ld are separated", separated, all);
}

static void fill(own_pair *own, generator *random, bool lattice)
{
    for (int i = 0; i < pair_size(own); i++)
        *pair_coordinate(own, i) =
            lattice ? below(random, 4) : uniform(random, -1, 1);
}

START_TEST(separated_moving_pairs_do_not_intersect)
{
    generator random = generator_new((uint64_t)_i);
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    long separated = 0, all = cases(4000);
    for (long i = 0; i < all; i++) {
        fill(&own, &random, i % 2);
        separated += expect_right(&own);
    }
    expect_both(separated, all);
}
END_TEST

START_TEST(separated_static_pairs_do_not_intersect)
{
    generator random = generator_new(10);
    own_pair own = {.event = {{.t = 0}}};
    long separated = 0, all = cases(8000);
    for (long i = 0; i < all; i++) {
        int axes = 1 + below(&random, 3);
        int first = 1 + below(&random, axes + 1);
        shape_static(&own, axes, first, axes + 2 - first);
        fill(&own, &random, i % 2);
        separated += expect_right(&own);
    }
    expect_both(separated, all);
}
END_TEST

START_TEST(an_operand_without_events_is_not_separated)
{
    static const tf_event event = {.x = {1, 2, 3}};
    tf_pair pair = {.axes = 3, .axis = {0, 1, 2}};
    ck_assert(!tf_pair_separated(&pair));

    // As many of one operand as there is room for.
    for (int i = 0; i < TF_PAIR_EVENTS; i++) {
        pair.event[i] = &event;
        pair.operand[i] = _i == 0 ? +1 : -1;
    }
    pair.count = TF_PAIR_EVENTS;
    for (pair.start_count = 0; pair.start_count <= pair.count;
         pair.start_count++)
        ck_assert_msg(!tf_pair_separated(&pair), "%d events at the start",
                      pair.start_count);
}
END_TEST

// Elements --------------------------------------------------------------------

static bool elements_separated(const query *q)
{
    return tf_elements_separated(q->axes, q->vertices, q->vertex, q->others,
                                 query_const_others(q));
}

/// Whether all pairs of simplices of the sweeps are separated.
static bool pairs_separated(const query *q)
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(q->vertices, q->vertex, s);
    tf_sweep(q->others, query_const_others(q), r);
    for (int i = 0; i < q->vertices; i++)
        for (int j = 0; j < q->others; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], q->axes);
            if (!tf_pair_separated(&pair))
                return false;
        }
    return true;
}

static bool meet_by_oracle(const query *q)
{
    mpq_t toi;
    mpq_init(toi);
    bool hit = oracle_meet(q->axes, q->vertices, q->vertex, q->others,
                           query_const_others(q), toi);
    mpq_clear(toi);
    return hit;
}

START_TEST(separated_elements_are_apart)
{
    generator random = generator_new((uint64_t)(20 + _i));
    long separated = 0, all = cases(6000);
    for (long i = 0; i < all; i++) {
        query q = i % 3 == 0   ? query_lattice(&random, (query_kind)_i, 4)
                  : i % 3 == 1 ? query_any(&random, (query_kind)_i)
                               : query_extreme(&random, (query_kind)_i);
        if (!elements_separated(&q))
            continue;
        separated++;
        ck_assert_msg(pairs_separated(&q), "a pair is not separated:\n%s",
                      query_text(&q));
        ck_assert_msg(!meet_by_oracle(&q), "a contact:\n%s", query_text(&q));
    }
    ck_assert_msg(20 * separated > all, "%ld of %ld are separated", separated,
                  all);
}
END_TEST

/// A lattice query whose first element is then moved along an axis, to where it
/// touches the box of the second one from above (direction +1) or from below.
static query beside(generator *random, query_kind kind, int axis, int direction)
{
    query q = query_lattice(random, kind, 4);
    for (int t = 0; t < 2; t++) {
        double gap = INFINITY;
        for (int i = 0; i < q.vertices; i++)
            for (int j = 0; j < q.others; j++)
                gap =
                    fmin(gap, direction * (q.vertex[i].at[t].x[axis] -
                                           query_others(&q)[j].at[t].x[axis]));
        for (int i = 0; i < q.vertices; i++)
            q.vertex[i].at[t].x[axis] -= direction * gap;
    }
    return q;
}

/// Move the first element, or the other away from it, by one unit in the last
/// place.
static void part(query *q, int axis, int direction, int t, bool first)
{
    tf_worldline *line = first ? q->vertex : query_others(q);
    for (int i = 0; i < (first ? q->vertices : q->others); i++) {
        double *x = &line[i].at[t].x[axis];
        *x = nextafter(*x, first == (direction > 0) ? DBL_MAX : -DBL_MAX);
    }
}

/// All other axes are made to overlap.
static void flatten(query *q, int axis)
{
    for (int i = 0; i < query_size(q); i++)
        if (i % q->axes != axis)
            *query_coordinate(q, i) = 0;
}

START_TEST(touching_elements_are_not_separated_one_ulp_apart_they_are)
{
    generator random = generator_new((uint64_t)(30 + _i));
    for (long i = 0; i < cases(2000); i++) {
        int axis = below(&random, _i == POINT_EDGE ? 2 : 3);
        int direction = below(&random, 2) ? 1 : -1, t = below(&random, 2);
        query q = beside(&random, (query_kind)_i, axis, direction);
        flatten(&q, axis);
        bool touching = elements_separated(&q);
        part(&q, axis, direction, t, below(&random, 2));
        bool parted_once = elements_separated(&q);
        part(&q, axis, direction, !t, below(&random, 2));
        ck_assert_msg(!touching && !parted_once && elements_separated(&q) &&
                          pairs_separated(&q),
                      "touching: %d, parted at t = %d: %d, at both: %d\n%s",
                      touching, t, parted_once, elements_separated(&q),
                      query_text(&q));
    }
}
END_TEST

START_TEST(elements_that_change_sides_are_not_separated)
{
    // The point is above the edge at the start and below it at the end.
    query q = query_new(POINT_EDGE);
    q.vertex[0].at[0].x[1] = 1;
    q.vertex[0].at[1].x[1] = -1;
    ck_assert(!elements_separated(&q));
    q.vertex[0].at[1].x[1] = 1;
    ck_assert(elements_separated(&q));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/separation");
    TCase *pairs = tcase_create("pairs");
    tcase_add_loop_test(pairs, separated_moving_pairs_do_not_intersect, 0,
                        SHAPES);
    tcase_add_test(pairs, separated_static_pairs_do_not_intersect);
    tcase_add_loop_test(pairs, an_operand_without_events_is_not_separated, 0,
                        2);
    suite_add_tcase(suite, pairs);
    TCase *elements = tcase_create("elements");
    tcase_add_loop_test(elements, separated_elements_are_apart, 0, KINDS);
    tcase_add_loop_test(
        elements, touching_elements_are_not_separated_one_ulp_apart_they_are, 0,
        KINDS);
    tcase_add_test(elements, elements_that_change_sides_are_not_separated);
    suite_add_tcase(suite, elements);
    return suite;
}
