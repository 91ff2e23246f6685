#include "intersect/time.h"

#include "support/pairs.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

START_TEST(the_smaller_operand_has_fewer_events)
{
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    int smaller = tf_pair_smaller_operand(&own.pair), count[2] = {0, 0};
    for (int i = 0; i < own.pair.count; i++)
        count[own.pair.operand[i] == smaller]++;
    ck_assert_int_le(count[1], count[0]);
    ck_assert_int_le(count[1], 3);
}
END_TEST

// A point's worldline, the events 0 and 3 of shape 0.

static tf_interval time_of(double start_low, double start_high, double end_low,
                           double end_high)
{
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, 0);
    tf_coordinates c = {.low = {[0] = start_low, [3] = end_low},
                        .high = {[0] = start_high, [3] = end_high}};
    return tf_pair_time(&own.pair, &c);
}

/// Compare t with a / (a + b), exactly.
static int compare(double t, double a, double b)
{
    mpq_t time, share, whole;
    mpq_inits(time, share, whole, NULL);
    mpq_set_d(time, t);
    mpq_set_d(share, a);
    mpq_set_d(whole, b);
    mpq_add(whole, whole, share);
    mpq_div(share, share, whole);
    int order = mpq_cmp(time, share);
    mpq_clears(time, share, whole, NULL);
    return order;
}

START_TEST(the_time_is_the_share_of_the_events_at_the_end)
{
    generator random = generator_new(1);
    for (long i = 0; i < cases(50000); i++) {
        int range = i % 2 ? 4 : 500;
        double a = ldexp(uniform(&random, 0.5, 1), -below(&random, range));
        double b = ldexp(uniform(&random, 0.5, 1), -below(&random, range));
        tf_interval t = time_of(a, a, b, b);
        ck_assert_msg(compare(t.lo, b, a) <= 0 && compare(t.hi, b, a) >= 0,
                      "[%a, %a] does not hold %a / (%a + %a)", t.lo, t.hi, b, b,
                      a);
        ck_assert_msg(0 <= t.lo && t.hi <= 1 && t.hi - t.lo <= 0x1p-50,
                      "[%a, %a] of %a and %a", t.lo, t.hi, a, b);
    }
}
END_TEST

START_TEST(the_time_holds_all_shares_of_wide_coordinates)
{
    generator random = generator_new(2);
    for (long i = 0; i < cases(20000); i++) {
        double a = uniform(&random, 0, 1), b = uniform(&random, 0, 1);
        double wider_a = a + uniform(&random, 0, 0.5);
        double wider_b = b + uniform(&random, 0, 0.5);
        tf_interval t = time_of(a, wider_a, b, wider_b);
        ck_assert_msg(compare(t.lo, b, wider_a) <= 0 &&
                          compare(t.hi, wider_b, a) >= 0,
                      "[%a, %a] of [%a, %a] and [%a, %a]", t.lo, t.hi, a,
                      wider_a, b, wider_b);
    }
}
END_TEST

static void expect_time(tf_interval found, double lo, double hi)
{
    ck_assert_msg(found.lo == lo && found.hi == hi, "[%a, %a], not [%a, %a]",
                  found.lo, found.hi, lo, hi);
}

START_TEST(the_ends_of_the_step_are_exact)
{
    expect_time(time_of(1, 1, 0, 0), 0, 0);
    expect_time(time_of(0, 1, 0, 0), 0, 0);
    expect_time(time_of(0, 0, 1, 1), 1, 1);
    expect_time(time_of(0, 0, 0, DBL_TRUE_MIN), 1, 1);
}
END_TEST

START_TEST(unknown_coordinates_leave_the_whole_step)
{
    expect_time(time_of(0, INFINITY, 0, INFINITY), 0, 1);
    expect_time(time_of(0, 1, 0, 1), 0, 1);
    expect_time(time_of(0, 0, 0, 0), 0, 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/time");
    TCase *tcase = tcase_create("time");
    tcase_add_loop_test(tcase, the_smaller_operand_has_fewer_events, 0, SHAPES);
    tcase_add_test(tcase, the_time_is_the_share_of_the_events_at_the_end);
    tcase_add_test(tcase, the_time_holds_all_shares_of_wide_coordinates);
    tcase_add_test(tcase, the_ends_of_the_step_are_exact);
    tcase_add_test(tcase, unknown_coordinates_leave_the_whole_step);
    suite_add_tcase(suite, tcase);
    return suite;
}
