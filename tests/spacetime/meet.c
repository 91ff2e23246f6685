#include "spacetime/meet.h"

#include "arithmetic/clamped.h"
#include "support/pairs.h"
#include "support/rational.h"
#include "support/support.h"

#include <signal.h>

static void expect_right(const own_pair *own, const tf_arithmetic *arithmetic)
{
    tf_meeting meeting = tf_meet(arithmetic, &own->pair);
    const char *fault =
        meeting_fault(own, &meeting, arithmetic == &oracle_arithmetic);
    ck_assert_msg(!fault, "%s: %s:\n%s", arithmetic->name, fault,
                  pair_text(own));
}

/// The coordinates as the digits of `number`.
static void fill_digits(own_pair *own, long number, int base)
{
    for (int i = 0; i < pair_size(own); i++, number /= base)
        *pair_coordinate(own, i) = (double)(number % base);
}

START_TEST(small_plane_pairs_meet_as_the_oracle_says)
{
    enum {
        ALL = 59049 // 3^10
    };
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    long step = ALL / cases(ALL);
    for (long number = 0; number < ALL; number += step) {
        fill_digits(&own, number, 3);
        expect_right(&own, &oracle_arithmetic);
        expect_right(&own, &tf_clamped);
    }
}
END_TEST

START_TEST(small_line_pairs_meet_as_the_oracle_says)
{
    for (long number = 0; number < 256; number++) {
        own_pair own = {.event = {{.t = 0}}};
        shape_static(&own, 1, 1, 1);
        own.event[2].t = own.event[3].t = 1;
        own.pair.count = 4;
        own.pair.event[2] = &own.event[2];
        own.pair.event[3] = &own.event[3];
        own.pair.side[2] = +1;
        own.pair.side[3] = -1;
        fill_digits(&own, number, 4);
        expect_right(&own, &oracle_arithmetic);
    }
}
END_TEST

/// Coordinates from 0 .. n-1, then on some of the axes those of another axis,
/// or all zero: flat, in line, still.
static void fill_flat(own_pair *own, generator *random)
{
    int n = 2 + below(random, 3), axes = own->pair.axes;
    int from[TF_AXES] = {0, below(random, 3) ? 1 : 0, below(random, 3)};
    for (int i = 0; i < pair_size(own); i++)
        *pair_coordinate(own, i) = below(random, n);
    for (int i = 0; i < own->pair.count; i++)
        for (int k = 1; k < axes; k++)
            own->event[i].x[k] = own->event[i].x[from[k]];
    if (below(random, 4) == 0)
        for (int i = 0; i < own->pair.early; i++)
            own->event[own->pair.count - 1 - i].x[axes - 1] = 1;
}

START_TEST(degenerate_pairs_meet_as_the_oracle_says)
{
    generator random = generator_new((uint64_t)_i);
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    for (long i = 0; i < cases(15000); i++) {
        fill_flat(&own, &random);
        expect_right(&own, &oracle_arithmetic);
        expect_right(&own, &tf_clamped);
    }
}
END_TEST

static void expect_earlier(tf_meeting a, tf_meeting b, tf_meeting expected)
{
    a.weight[0] = 1;
    b.weight[0] = 2;
    tf_meeting got = tf_meeting_earlier(&a, &b);
    ck_assert_int_eq(got.verdict, expected.verdict);
    if (expected.verdict == TF_APART)
        return;
    ck_assert_double_eq(got.toi_lo, expected.toi_lo);
    ck_assert_double_eq(got.toi_hi, expected.toi_hi);
    ck_assert_double_eq(got.weight[0], expected.weight[0]);
}

static tf_meeting at(tf_verdict verdict, double lo, double hi)
{
    return (tf_meeting){.verdict = verdict, .toi_lo = lo, .toi_hi = hi};
}

static tf_meeting from(int which, tf_meeting meeting)
{
    meeting.weight[0] = which;
    return meeting;
}

START_TEST(earlier_meeting_keeps_what_is_certain)
{
    tf_meeting apart = tf_meeting_apart;
    expect_earlier(apart, apart, apart);
    expect_earlier(apart, at(TF_HIT, 0.5, 0.6), from(2, at(TF_HIT, 0.5, 0.6)));
    expect_earlier(at(TF_HIT, 0.5, 0.6), apart, from(1, at(TF_HIT, 0.5, 0.6)));
    expect_earlier(at(TF_HIT, 0.5, 0.6), at(TF_HIT, 0.4, 0.7),
                   from(2, at(TF_HIT, 0.4, 0.6)));
    expect_earlier(at(TF_HIT, 0.4, 0.6), at(TF_HIT, 0.4, 0.5),
                   from(1, at(TF_HIT, 0.4, 0.5)));

    // What may not happen cannot end the wait.
    expect_earlier(at(TF_UNDECIDED, 0.1, 0.2), at(TF_HIT, 0.5, 0.6),
                   from(1, at(TF_HIT, 0.1, 0.6)));
    expect_earlier(at(TF_HIT, 0.5, 0.6), at(TF_UNDECIDED, 0.7, 0.8),
                   from(1, at(TF_HIT, 0.5, 0.6)));
    expect_earlier(at(TF_UNDECIDED, 0.1, 0.2), at(TF_UNDECIDED, 0.3, 0.4),
                   from(1, at(TF_UNDECIDED, 0.1, 0.4)));
    expect_earlier(apart, at(TF_UNDECIDED, 0.3, 0.4),
                   from(2, at(TF_UNDECIDED, 0.3, 0.4)));
}
END_TEST

START_TEST(static_pair_breaks_the_contract)
{
    own_pair own = {.event = {{.t = 0}}};
    shape_static(&own, 3, 1, 3);
    tf_meet(&oracle_arithmetic, &own.pair);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("spacetime/meet");
    TCase *tcase = tcase_create("meet");
    tcase_add_test(tcase, small_line_pairs_meet_as_the_oracle_says);
    tcase_add_loop_test(tcase, small_plane_pairs_meet_as_the_oracle_says, 0, 2);
    tcase_add_loop_test(tcase, degenerate_pairs_meet_as_the_oracle_says, 0,
                        SHAPES);
    tcase_add_test(tcase, earlier_meeting_keeps_what_is_certain);
    tcase_add_test_raise_signal(tcase, static_pair_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
