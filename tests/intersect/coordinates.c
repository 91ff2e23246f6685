#include "intersect/coordinates.h"

#include "arithmetic/functions.h"
#include "support/pairs.h"
#include "support/rational.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

static double exact_value(const tf_pair *pair, int i)
{
    tf_differences differences;
    tf_pair_differences(pair, i, &differences);
    tf_value value = oracle_arithmetic.value(&differences);
    return ldexp(value.number, value.exponent);
}

/// Fill a pair with small integers until its signs are in no conflict, and not
/// all zero.
static tf_signs fill_good(own_pair *own, generator *random)
{
    tf_signs signs;
    do {
        for (int i = 0; i < pair_size(own); i++)
            *pair_coordinate(own, i) = below(random, 4);
        find_signs(&oracle_arithmetic, &own->pair, &signs);
    } while (signs.positive == signs.negative);
    return signs;
}

/// The first event of the operand whose sign is not zero.
static int first_of(const tf_pair *pair, const tf_signs *signs, int operand)
{
    int i = 0;
    while (pair->operand[i] != operand || signs->sign[i] == TF_ZERO)
        i++;
    return i;
}

/// Expect the determinants of an operand's events, but for their common sign
/// and a power of two, and zeros for those of the other operand.
static void expect_coordinates(const own_pair *own, const tf_signs *signs,
                               int operand)
{
    const tf_pair *pair = &own->pair;
    tf_coordinates c;
    tf_pair_coordinates(&oracle_arithmetic, pair, signs, operand, NULL, &c);
    int first = first_of(pair, signs, operand);
    double scale = c.low[first] / fabs(exact_value(pair, first));
    for (int i = 0; i < pair->count; i++) {
        bool own_event = pair->operand[i] == operand;
        double expected = own_event ? scale * fabs(exact_value(pair, i)) : 0;
        ck_assert_msg(c.low[i] == expected && c.high[i] == expected,
                      "coordinate %d: [%a, %a], expected %a:\n%s", i, c.low[i],
                      c.high[i], expected, pair_text(own));
    }
    int exponent;
    ck_assert_double_eq(frexp(scale, &exponent), 0.5);
}

START_TEST(coordinates_are_the_determinants_up_to_a_factor)
{
    generator random = generator_new((uint64_t)_i);
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    for (long i = 0; i < cases(1000); i++) {
        tf_signs signs = fill_good(&own, &random);
        expect_coordinates(&own, &signs, +1);
        expect_coordinates(&own, &signs, -1);
    }
}
END_TEST

// Values that are not exact ---------------------------------------------------

/// A pair whose values are all the same.
static tf_value given;

static tf_value given_value(const tf_differences *differences)
{
    (void)differences;
    return given;
}

static tf_coordinates coordinates_of(tf_value value, const own_pair *own,
                                     const tf_signs *signs)
{
    tf_arithmetic arithmetic = oracle_arithmetic;
    arithmetic.value = given_value;
    given = value;
    tf_coordinates c;
    tf_pair_coordinates(&arithmetic, &own->pair, signs, +1, NULL, &c);
    return c;
}

/// The point of shape 0: its only two events are 0 and 3.
static own_pair make_point(void)
{
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, 0);
    ck_assert_int_eq(own.pair.operand[0], +1);
    ck_assert_int_eq(own.pair.operand[3], +1);
    return own;
}

static const tf_signs unknown_signs = {
    .unknown = true,
    .sign = {TF_UNKNOWN, TF_UNKNOWN, TF_UNKNOWN, TF_UNKNOWN, TF_UNKNOWN}};

START_TEST(a_radius_widens_a_coordinate_but_not_below_zero)
{
    own_pair own = make_point();
    tf_coordinates c = coordinates_of((tf_value){.number = 1, .radius = 0.25},
                                      &own, &unknown_signs);
    double scale = (c.low[0] + c.high[0]) / 2;
    int up = tf_pair_orientation(&own.pair, 0) > 0 ? 0 : 3;
    scale = (c.low[up] + c.high[up]) / 2;
    ck_assert_double_eq(c.low[up], 0.75 * scale);
    ck_assert_double_eq(c.high[up], 1.25 * scale);

    c = coordinates_of((tf_value){.number = 1, .radius = 4}, &own,
                       &unknown_signs);
    ck_assert_double_eq(c.low[up], 0);
    ck_assert_double_gt(c.high[up], 0);
}
END_TEST

START_TEST(unknown_coordinates_may_be_anything)
{
    static const tf_value unknown[] = {
        {.number = NAN}, {.number = INFINITY}, {.number = 1, .radius = NAN}};
    own_pair own = make_point();
    tf_coordinates c = coordinates_of(unknown[_i], &own, &unknown_signs);
    for (int i = 0; i < 4; i += 3) {
        ck_assert_double_eq(c.low[i], 0);
        ck_assert(isinf(c.high[i]));
    }
    double barycentric[TF_PAIR_EVENTS];
    tf_coordinates_normalize(&c, &own.pair, +1, barycentric);
    ck_assert_double_eq(barycentric[0], 0.5);
    ck_assert_double_eq(barycentric[3], 0.5);
}
END_TEST

START_TEST(only_a_certain_zero_is_zero)
{
    own_pair own = make_point();
    tf_signs signs = unknown_signs;
    signs.sign[3] = TF_ZERO;
    tf_coordinates c = coordinates_of((tf_value){.number = 0}, &own, &signs);
    ck_assert_double_eq(c.low[0], 0);
    ck_assert_double_gt(c.high[0], 0);
    ck_assert_double_eq(c.low[3], 0);
    ck_assert_double_eq(c.high[3], 0);
}
END_TEST

// Normalizing -----------------------------------------------------------------

START_TEST(middles_are_divided_by_their_sum)
{
    own_pair own = make_point();
    tf_coordinates c = {.low = {[0] = 1, [3] = 5}, .high = {[0] = 3, [3] = 7}};
    double barycentric[TF_PAIR_EVENTS] = {9, 9, 9, 9, 9, 9};
    tf_coordinates_normalize(&c, &own.pair, +1, barycentric);
    ck_assert_double_eq(barycentric[0], 0.25);
    ck_assert_double_eq(barycentric[3], 0.75);

    // What belongs to the other operand stays.
    for (int i = 1; i < own.pair.count; i += i == 2 ? 2 : 1)
        ck_assert_double_eq(barycentric[i], 9);
}
END_TEST

START_TEST(small_middles_are_divided_by_their_sum)
{
    own_pair own = make_point();
    tf_coordinates c = {.low = {[0] = 0, [3] = 0},
                        .high = {[0] = 0x1p-900, [3] = 0x3p-900}};
    double barycentric[TF_PAIR_EVENTS];
    tf_coordinates_normalize(&c, &own.pair, +1, barycentric);
    ck_assert_double_eq(barycentric[0], 0.25);
    ck_assert_double_eq(barycentric[3], 0.75);
}
END_TEST

START_TEST(coordinates_that_are_all_zero_have_no_middle)
{
    own_pair own = make_point();
    tf_coordinates c = {.low = {0}, .high = {0}};
    double barycentric[TF_PAIR_EVENTS];
    tf_coordinates_normalize(&c, &own.pair, +1, barycentric);
    ck_assert_double_eq(barycentric[0], 0.5);
    ck_assert_double_eq(barycentric[3], 0.5);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/coordinates");
    TCase *tcase = tcase_create("coordinates");
    tcase_add_loop_test(tcase, coordinates_are_the_determinants_up_to_a_factor,
                        0, SHAPES);
    tcase_add_test(tcase, a_radius_widens_a_coordinate_but_not_below_zero);
    tcase_add_loop_test(tcase, unknown_coordinates_may_be_anything, 0, 3);
    tcase_add_test(tcase, only_a_certain_zero_is_zero);
    tcase_add_test(tcase, middles_are_divided_by_their_sum);
    tcase_add_test(tcase, small_middles_are_divided_by_their_sum);
    tcase_add_test(tcase, coordinates_that_are_all_zero_have_no_middle);
    suite_add_tcase(suite, tcase);
    return suite;
}
