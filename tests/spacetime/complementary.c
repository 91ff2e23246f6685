#include "spacetime/complementary.h"

#include "arithmetic/clamped.h"
#include "support/pairs.h"
#include "support/rational.h"
#include "support/support.h"

#include <float.h>
#include <math.h>
#include <signal.h>

static void fill_lattice(own_pair *own, generator *random, int n)
{
    for (int i = 0; i < pair_size(own); i++)
        *pair_coordinate(own, i) = below(random, n);
}

static void fill_soup(own_pair *own, generator *random)
{
    for (int i = 0; i < pair_size(own); i++)
        *pair_coordinate(own, i) = uniform(random, -1, 1);
}

static void expect_right(const own_pair *own, const tf_arithmetic *arithmetic)
{
    tf_meeting meeting;
    if (!tf_complementary_meet(arithmetic, &own->pair, &meeting))
        return;
    const char *fault =
        meeting_fault(own, &meeting, arithmetic == &oracle_arithmetic);
    ck_assert_msg(!fault, "%s: %s:\n%s", arithmetic->name, fault,
                  pair_text(own));
}

START_TEST(moving_pairs_meet_as_the_oracle_says)
{
    generator random = generator_new((uint64_t)_i);
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    for (long i = 0; i < cases(4000); i++) {
        if (i % 2 == 0)
            fill_soup(&own, &random);
        else
            fill_lattice(&own, &random, 3);
        expect_right(&own, &oracle_arithmetic);
        expect_right(&own, &tf_clamped);
    }
}
END_TEST

START_TEST(static_pairs_meet_as_the_oracle_says)
{
    generator random = generator_new((uint64_t)(10 + _i));
    own_pair own = {.event = {{.t = 0}}};
    for (long i = 0; i < cases(4000); i++) {
        int axes = 1 + below(&random, 3);
        int first = 1 + below(&random, axes + 1);
        shape_static(&own, axes, first, axes + 2 - first);
        if (_i == 0)
            fill_soup(&own, &random);
        else
            fill_lattice(&own, &random, 3);
        expect_right(&own, &oracle_arithmetic);
        expect_right(&own, &tf_clamped);
    }
}
END_TEST

/// The rank of small integer rows, by elimination without fractions.
static int rank_of(long row[][TF_AXES + 2], int rows, int columns)
{
    int rank = 0;
    for (int c = 0; c < columns && rank < rows; c++) {
        int pivot = rank;
        while (pivot < rows && row[pivot][c] == 0)
            pivot++;
        if (pivot == rows)
            continue;
        for (int k = 0; k < columns; k++) {
            long swapped = row[rank][k];
            row[rank][k] = row[pivot][k];
            row[pivot][k] = swapped;
        }
        for (int i = rank + 1; i < rows; i++) {
            long factor = row[i][c];
            for (int k = 0; k < columns; k++)
                row[i][k] = row[i][k] * row[rank][c] - row[rank][k] * factor;
        }
        rank++;
    }
    return rank;
}

/// Whether the events of a moving lattice pair lie in a hyperplane.
static bool flat(const own_pair *own)
{
    long row[TF_PAIR_EVENTS][TF_AXES + 2];
    int axes = own->pair.axes;
    for (int i = 0; i < own->pair.count; i++) {
        for (int k = 0; k < axes; k++)
            row[i][k] = (long)own->event[i].x[k];
        row[i][axes] = own->event[i].t;
        row[i][axes + 1] = 1;
    }
    return rank_of(row, own->pair.count, axes + 2) < axes + 2;
}

START_TEST(signs_tell_nothing_only_in_a_hyperplane)
{
    generator random = generator_new((uint64_t)(20 + _i));
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    for (long i = 0; i < cases(20000); i++) {
        fill_lattice(&own, &random, 2);
        tf_meeting meeting;
        bool told =
            tf_complementary_meet(&oracle_arithmetic, &own.pair, &meeting);
        ck_assert_msg(told || flat(&own), "no answer:\n%s", pair_text(&own));
        ck_assert_msg(!told || meeting.verdict == TF_APART || meeting.unique,
                      "not unique:\n%s", pair_text(&own));
    }
}
END_TEST

// A point that falls from y = 1 to y = -1 at x, and the edge from (0,0) to (2,0)
// with its second vertex in both events.

static void make_falling_point(own_pair *own, double x)
{
    *own = (own_pair){.event = {{.x = {x, 1}},
                                {.x = {0, 0}},
                                {.x = {x, -1}},
                                {.x = {0, 0}},
                                {.x = {2, 0}}}};
    shape_moving(own, 1);
}

static void expect_fall(double x, tf_verdict verdict, tf_decision decision)
{
    own_pair own;
    make_falling_point(&own, x);
    tf_meeting meeting;
    ck_assert(tf_complementary_meet(&oracle_arithmetic, &own.pair, &meeting));
    ck_assert_int_eq(meeting.verdict, verdict);
    if (verdict == TF_APART)
        return;
    ck_assert_int_eq(meeting.decision, decision);
    ck_assert_double_le(meeting.toi_lo, 0.5);
    ck_assert_double_ge(meeting.toi_hi, 0.5);
}

START_TEST(falling_point_meets_the_edge)
{
    // At t = 1/2 this simplex is the segment from (0,0) to (1,0).
    expect_fall(0.25, TF_HIT, TF_GENERIC);
    expect_fall(0, TF_HIT, TF_TOUCHING);
    expect_fall(1, TF_HIT, TF_TOUCHING);
    expect_fall(1.25, TF_APART, TF_GENERIC);
    expect_fall(-0.25, TF_APART, TF_GENERIC);
}
END_TEST

START_TEST(differences_are_taken_within_each_time)
{
    own_pair own;
    make_falling_point(&own, 0.25);
    tf_differences d = tf_pair_differences(&own.pair, 1);
    ck_assert_int_eq(d.n, 2);
    for (int i = 0; i < 2; i++) {
        ck_assert_ptr_eq(d.to[i], &own.event[3 + i]);
        ck_assert_ptr_eq(d.from[i], &own.event[2]);
    }
}
END_TEST

START_TEST(pair_sorts_events_by_time)
{
    tf_worldline vertex[4] = {{.at = {{.t = 0}, {.t = 1}}}};
    for (int i = 1; i < 4; i++)
        vertex[i] = vertex[0];
    tf_simplex s[1], r[3];
    tf_sweep(1, vertex, s);
    tf_sweep(3, vertex + 1, r);
    tf_pair pair = tf_pair_of(&s[0], &r[1], 3);
    static const int sides[] = {+1, -1, -1, +1, -1, -1};
    ck_assert_int_eq(pair.count, 6);
    ck_assert_int_eq(pair.early, 3);
    for (int i = 0; i < 6; i++) {
        ck_assert_int_eq(pair.event[i]->t, i >= 3);
        ck_assert_int_eq(pair.side[i], sides[i]);
    }
}
END_TEST

START_TEST(pair_that_is_not_complementary_breaks_the_contract)
{
    tf_worldline vertex = {.at = {{.t = 0}, {.t = 1}}};
    tf_simplex s[1];
    tf_sweep(1, &vertex, s);
    tf_pair_of(&s[0], &s[0], 3);
}
END_TEST

// Values ----------------------------------------------------------------------

static tf_value value_of(double number, double radius, int exponent, int order)
{
    return (tf_value){.number = number,
                      .radius = radius,
                      .exponent = exponent,
                      .order = {order}};
}

START_TEST(what_scaling_loses_the_radius_gains)
{
    // Scaled by 2^-1000 the number is 0.6 of the least double.
    tf_value value[] = {value_of(0x1p1000, 1, 0, 0),
                        value_of(0x1.3333333333333p-75, 0x1p-200, 0, 0)};
    tf_values_scale(2, value);
    ck_assert_double_eq(value[0].number, 1);
    ck_assert_int_eq(value[1].exponent, 0);
    double truth = 0x1.3333333333333p-75 * 0x1p75; // in units of 2^-1075
    ck_assert_double_le((value[1].number - value[1].radius) * 0x1p1000 * 0x1p75,
                        truth);
    ck_assert_double_ge((value[1].number + value[1].radius) * 0x1p1000 * 0x1p75,
                        truth);
    ck_assert_double_ge(value[1].radius, DBL_TRUE_MIN);
}
END_TEST

START_TEST(what_is_infinitely_smaller_becomes_zero)
{
    tf_value value[] = {value_of(0x1p-900, 0, -900, 0),
                        value_of(0x1p900, 0, 900, 7), value_of(0, 0, 0, 0)};
    tf_values_scale(3, value);
    ck_assert_double_eq(value[0].number, 1);
    ck_assert_double_eq(value[1].number, 0);
    ck_assert_int_eq(value[1].order[0], 0);
    ck_assert_double_eq(value[2].number, 0);

    // The order counts, not the size; alone an infinitesimal is the largest.
    tf_value small[] = {value_of(-3, 0, 0, 9), value_of(5, 0, 0, 8)};
    tf_values_scale(2, small);
    ck_assert_double_eq(small[0].number, 0);
    ck_assert_double_eq(small[1].number, 1.25);
}
END_TEST

START_TEST(what_is_not_known_stays_so)
{
    tf_value value[] = {value_of(INFINITY, 0, 0, 0), value_of(8, NAN, 0, 0),
                        value_of(-2, 0, 3, 0)};
    tf_values_scale(3, value);
    ck_assert(!isfinite(value[0].number + value[0].radius));
    ck_assert(!isfinite(value[1].number + value[1].radius));
    ck_assert_double_eq(value[2].number, -1);
    ck_assert_int_eq(value[2].exponent, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("spacetime/complementary");
    TCase *tcase = tcase_create("complementary");
    tcase_add_loop_test(tcase, moving_pairs_meet_as_the_oracle_says, 0, SHAPES);
    tcase_add_loop_test(tcase, static_pairs_meet_as_the_oracle_says, 0, 2);
    tcase_add_loop_test(tcase, signs_tell_nothing_only_in_a_hyperplane, 0,
                        SHAPES);
    tcase_add_test(tcase, falling_point_meets_the_edge);
    tcase_add_test(tcase, differences_are_taken_within_each_time);
    tcase_add_test(tcase, pair_sorts_events_by_time);
    tcase_add_test_raise_signal(
        tcase, pair_that_is_not_complementary_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    TCase *values = tcase_create("values");
    tcase_add_test(values, what_scaling_loses_the_radius_gains);
    tcase_add_test(values, what_is_infinitely_smaller_becomes_zero);
    tcase_add_test(values, what_is_not_known_stays_so);
    suite_add_tcase(suite, values);
    return suite;
}
