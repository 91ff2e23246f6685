#include "intersect/cascade.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "support/pairs.h"
#include "support/queries.h"
#include "support/rational.h"
#include "support/support.h"

#include <math.h>
#include <signal.h>

static void expect_right(const own_pair *own, const tf_arithmetic *arithmetic)
{
    tf_intersection found = tf_intersect(arithmetic, &own->pair, TF_WITH_POINT);
    const char *fault =
        intersection_fault(own, &found, arithmetic == &oracle_arithmetic);
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
        own.pair.operand[2] = +1;
        own.pair.operand[3] = -1;
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
        for (int i = 0; i < own->pair.start_count; i++)
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

// A point at rest on a triangle at rest, where signs decide nothing and only
// the projection along one axis has values.

static int good_axis;
static bool turns_axes;

static bool is_good(const tf_differences *d)
{
    for (int j = 0; j < d->n; j++)
        if (d->axis[j] == good_axis)
            return false;
    return d->n == 2;
}

/// All zero in space, and in the plane known only of the good projection.
static tf_sign sign_of_projection(const tf_differences *differences)
{
    return differences->n == 3 ? TF_ZERO : TF_UNKNOWN;
}

static tf_sign sign_of_good_projection(const tf_differences *differences)
{
    return is_good(differences) ? oracle_arithmetic.sign(differences)
                                : sign_of_projection(differences);
}

/// Where no sign is known all are taken for positive, as they are if the axes
/// come in the order 1 2, 2 0 and 0 1.
static tf_value value_of_good_projection(const tf_differences *differences)
{
    if (!is_good(differences))
        return (tf_value){.number = NAN};
    tf_value value = oracle_arithmetic.value(differences);
    if (good_axis == 1 && turns_axes)
        value.number = -value.number;
    return value;
}

static void expect_good_projection(tf_sign sign(const tf_differences *),
                                   tf_verdict verdict, double unit)
{
    static const double corner[4][TF_AXES] = {
        {0.5, 0.25, 0.25}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    query q = query_new(POINT_TRIANGLE);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = unit * corner[i / 3 % 4][i % 3];
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(1, q.vertex, s);
    tf_sweep(3, query_others(&q), r);
    tf_pair pair = tf_pair_of(&s[0], &r[0], 3);

    tf_arithmetic arithmetic = oracle_arithmetic;
    arithmetic.sign = sign;
    arithmetic.value = value_of_good_projection;
    tf_intersection found = tf_intersect(&arithmetic, &pair, TF_WITH_POINT);
    ck_assert_msg(found.verdict == verdict && found.toi_lo == 0,
                  "axis %d: verdict %d at [%a, %a]", good_axis, found.verdict,
                  found.toi_lo, found.toi_hi);
    for (int k = 0; k < 3; k++)
        ck_assert_msg(fabs(found.barycentric[1 + k] - corner[0][k]) < 1e-12,
                      "axis %d: barycentric %d is %a", good_axis, k,
                      found.barycentric[1 + k]);
}

START_TEST(the_projection_that_fits_best_gives_the_coordinates)
{
    good_axis = _i;
    turns_axes = true;
    expect_good_projection(sign_of_projection, TF_UNDECIDED, 1);
    expect_good_projection(sign_of_projection, TF_UNDECIDED, 0x1p-300);
}
END_TEST

START_TEST(a_unique_intersection_needs_no_other_projection)
{
    good_axis = _i;
    expect_good_projection(sign_of_good_projection, TF_HIT, 1);
}
END_TEST

// Whichever axis a pair is flat along, the projection along that axis comes
// first, so it takes the same signs to see that the pair is apart.

static long signs_taken;

static tf_sign count_sign(const tf_differences *differences)
{
    signs_taken++;
    return oracle_arithmetic.sign(differences);
}

/// Puts a flat pair up along an axis: low at the start, high at the end.
static void fill_along(own_pair *own, int flat, double plane[][2])
{
    for (int i = 0; i < own->pair.count; i++) {
        double *x = own->event[i].x;
        x[flat] = own->event[i].t;
        x[flat == 0 ? 1 : 0] = plane[i][0];
        x[flat == 2 ? 1 : 2] = plane[i][1];
    }
}

START_TEST(a_flat_axis_comes_first)
{
    generator random = generator_new((uint64_t)_i);
    tf_arithmetic counting = oracle_arithmetic;
    counting.sign = count_sign;
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    long apart = 0;
    for (long i = 0; i < cases(1000); i++) {
        double plane[TF_PAIR_EVENTS][2];
        for (int j = 0; j < own.pair.count; j++)
            for (int k = 0; k < 2; k++)
                plane[j][k] = uniform(&random, -1, 1);
        long taken[TF_AXES] = {0};
        tf_verdict verdict = TF_APART;
        for (int flat = 0; flat < TF_AXES; flat++) {
            fill_along(&own, flat, plane);
            signs_taken = 0;
            verdict = tf_intersect(&counting, &own.pair, TF_WITH_POINT).verdict;
            taken[flat] = signs_taken;
        }
        if (verdict != TF_APART)
            continue;
        apart++;
        ck_assert_int_eq(taken[0], taken[1]);
        ck_assert_int_eq(taken[0], taken[2]);
    }
    ck_assert_int_gt(apart, 0);
}
END_TEST

static void expect_earlier(tf_intersection a, tf_intersection b,
                           tf_intersection expected)
{
    a.barycentric[0] = 1;
    b.barycentric[0] = 2;
    tf_intersection got = tf_intersection_earlier(&a, &b);
    ck_assert_int_eq(got.verdict, expected.verdict);
    if (expected.verdict == TF_APART)
        return;
    ck_assert_double_eq(got.toi_lo, expected.toi_lo);
    ck_assert_double_eq(got.toi_hi, expected.toi_hi);
    ck_assert_double_eq(got.barycentric[0], expected.barycentric[0]);
}

static tf_intersection at(tf_verdict verdict, double lo, double hi)
{
    return (tf_intersection){.verdict = verdict, .toi_lo = lo, .toi_hi = hi};
}

static tf_intersection from(int which, tf_intersection found)
{
    found.barycentric[0] = which;
    return found;
}

START_TEST(the_earlier_intersection_keeps_all_that_is_certain)
{
    tf_intersection apart = tf_intersection_apart;
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

START_TEST(a_static_pair_breaks_the_contract)
{
    own_pair own = {.event = {{.t = 0}}};
    shape_static(&own, 3, 1, 3);
    tf_intersect(&oracle_arithmetic, &own.pair, TF_WITH_POINT);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/cascade");
    TCase *tcase = tcase_create("cascade");
    tcase_add_test(tcase, small_line_pairs_meet_as_the_oracle_says);
    tcase_add_loop_test(tcase, small_plane_pairs_meet_as_the_oracle_says, 0, 2);
    tcase_add_loop_test(tcase, degenerate_pairs_meet_as_the_oracle_says, 0,
                        SHAPES);
    tcase_add_loop_test(
        tcase, the_projection_that_fits_best_gives_the_coordinates, 0, TF_AXES);
    tcase_add_loop_test(tcase, a_unique_intersection_needs_no_other_projection,
                        0, TF_AXES);
    tcase_add_loop_test(tcase, a_flat_axis_comes_first, 2, SHAPES);
    tcase_add_test(tcase, the_earlier_intersection_keeps_all_that_is_certain);
    tcase_add_test_raise_signal(tcase, a_static_pair_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
