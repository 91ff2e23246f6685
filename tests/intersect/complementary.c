#include "intersect/complementary.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "support/pairs.h"
#include "support/rational.h"
#include "support/support.h"

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
    tf_intersection found;
    if (!tf_complementary_intersect(arithmetic, &own->pair, TF_WITH_POINT,
                                    &found))
        return;
    const char *fault =
        intersection_fault(own, &found, arithmetic == &oracle_arithmetic);
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

START_TEST(signs_decide_outside_a_hyperplane)
{
    generator random = generator_new((uint64_t)(20 + _i));
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    for (long i = 0; i < cases(20000); i++) {
        fill_lattice(&own, &random, 2);
        tf_intersection found;
        bool told = tf_complementary_intersect(&oracle_arithmetic, &own.pair,
                                               TF_WITH_POINT, &found);
        ck_assert_msg(told || flat(&own), "no answer:\n%s", pair_text(&own));
        ck_assert_msg(!told || found.verdict == TF_APART || found.unique,
                      "not unique:\n%s", pair_text(&own));
    }
}
END_TEST

// A point that falls from y = 1 to y = -1 at x, and the edge from (0,0) to
// (2,0) with its second vertex in both events.

static void make_falling_point(own_pair *own, double x)
{
    *own = (own_pair){.event = {{.x = {x, 1}},
                                {.x = {0, 0}},
                                {.x = {x, -1}},
                                {.x = {0, 0}},
                                {.x = {2, 0}}}};
    shape_moving(own, 1);
}

static void expect_fall(double x, tf_verdict verdict,
                        tf_classification classification)
{
    own_pair own;
    make_falling_point(&own, x);
    tf_intersection found;
    ck_assert(tf_complementary_intersect(&oracle_arithmetic, &own.pair,
                                         TF_WITH_POINT, &found));
    ck_assert_int_eq(found.verdict, verdict);
    ck_assert_int_eq(found.classification, classification);
    if (verdict == TF_APART)
        return;
    ck_assert_double_le(found.toi_lo, 0.5);
    ck_assert_double_ge(found.toi_hi, 0.5);
}

START_TEST(a_falling_point_meets_the_edge)
{
    // At t = 1/2 this simplex is the segment from (0,0) to (1,0).
    expect_fall(0.25, TF_HIT, TF_GENERIC);
    expect_fall(0, TF_HIT, TF_TOUCHING);
    expect_fall(1, TF_HIT, TF_TOUCHING);
    expect_fall(1.25, TF_APART, TF_UNCLASSIFIED);
    expect_fall(-0.25, TF_APART, TF_UNCLASSIFIED);
}
END_TEST

// Signs of our own choice, where any of them may be unknown.

static tf_sign unknown_sign(const tf_differences *differences)
{
    (void)differences;
    return TF_UNKNOWN;
}

/// The sign of the determinant, but only of those that are not zero.
static tf_sign nonzero_sign(const tf_differences *differences)
{
    tf_sign sign = oracle_arithmetic.sign(differences);
    return sign == TF_ZERO ? TF_UNKNOWN : sign;
}

static tf_intersection fall_with(tf_sign sign(const tf_differences *), double x)
{
    own_pair own;
    make_falling_point(&own, x);
    tf_arithmetic arithmetic = oracle_arithmetic;
    arithmetic.sign = sign;
    tf_intersection found;
    ck_assert(tf_complementary_intersect(&arithmetic, &own.pair, TF_WITH_POINT,
                                         &found));
    return found;
}

START_TEST(unknown_signs_are_classified_as_touching)
{
    tf_intersection found = fall_with(nonzero_sign, 0);
    ck_assert_int_eq(found.verdict, TF_UNDECIDED);
    ck_assert_int_eq(found.classification, TF_TOUCHING);
    ck_assert(found.unique);
    ck_assert_double_le(found.toi_hi - found.toi_lo, 0x1p-49);
}
END_TEST

START_TEST(without_any_sign_a_moving_pair_may_meet_at_any_time)
{
    tf_intersection found = fall_with(unknown_sign, 0.25);
    ck_assert_int_eq(found.verdict, TF_UNDECIDED);
    ck_assert_int_eq(found.classification, TF_TOUCHING);
    ck_assert(!found.unique);
    ck_assert_double_eq(found.toi_lo, 0);
    ck_assert_double_eq(found.toi_hi, 1);
}
END_TEST

START_TEST(an_axis_separates_without_any_sign)
{
    ck_assert_int_eq(fall_with(unknown_sign, 5).verdict, TF_APART);
    ck_assert_int_eq(fall_with(unknown_sign, -1).verdict, TF_APART);
}
END_TEST

static int values_computed;

static tf_value counted_value(const tf_differences *differences)
{
    values_computed++;
    return oracle_arithmetic.value(differences);
}

START_TEST(an_intersection_is_described_once)
{
    own_pair own;
    make_falling_point(&own, 0.25);
    tf_arithmetic arithmetic = oracle_arithmetic;
    arithmetic.value = counted_value;
    tf_intersection found;
    ck_assert(tf_complementary_intersect(&arithmetic, &own.pair, TF_WITH_POINT,
                                         &found));
    ck_assert_int_eq(found.detail, TF_WITH_POINT);
    values_computed = 0;
    tf_complementary_describe(&arithmetic, &own.pair, TF_WITH_TIME, &found);
    tf_complementary_describe(&arithmetic, &own.pair, TF_WITH_POINT, &found);
    ck_assert_int_eq(found.detail, TF_WITH_POINT);
    ck_assert_int_eq(values_computed, 0);
}
END_TEST

START_TEST(without_any_sign_a_static_pair_still_meets_at_the_start)
{
    own_pair own = {
        .event = {{.x = {1, 1}}, {.x = {0, 0}}, {.x = {4, 0}}, {.x = {0, 4}}}};
    shape_static(&own, 2, 1, 3);
    tf_arithmetic arithmetic = oracle_arithmetic;
    arithmetic.sign = unknown_sign;
    tf_intersection found;
    ck_assert(tf_complementary_intersect(&arithmetic, &own.pair, TF_WITH_POINT,
                                         &found));
    ck_assert_int_eq(found.verdict, TF_UNDECIDED);
    ck_assert_double_eq(found.toi_lo, 0);
    ck_assert_double_eq(found.toi_hi, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/complementary");
    TCase *tcase = tcase_create("complementary");
    tcase_add_loop_test(tcase, moving_pairs_meet_as_the_oracle_says, 0, SHAPES);
    tcase_add_loop_test(tcase, static_pairs_meet_as_the_oracle_says, 0, 2);
    tcase_add_loop_test(tcase, signs_decide_outside_a_hyperplane, 0, SHAPES);
    tcase_add_test(tcase, a_falling_point_meets_the_edge);
    tcase_add_test(tcase, unknown_signs_are_classified_as_touching);
    tcase_add_test(tcase, without_any_sign_a_moving_pair_may_meet_at_any_time);
    tcase_add_test(tcase, an_axis_separates_without_any_sign);
    tcase_add_test(tcase, an_intersection_is_described_once);
    tcase_add_test(tcase,
                   without_any_sign_a_static_pair_still_meets_at_the_start);
    suite_add_tcase(suite, tcase);
    return suite;
}
