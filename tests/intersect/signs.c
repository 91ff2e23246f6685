#include "intersect/signs.h"

#include "arithmetic/functions.h"
#include "support/counting_arithmetic.h"
#include "support/pairs.h"
#include "support/rational.h"
#include "support/support.h"

#include <math.h>

static void fill_lattice(own_pair *own, generator *random, int n)
{
    for (int i = 0; i < pair_size(own); i++)
        *pair_coordinate(own, i) = below(random, n);
}

/// The determinant that belongs to event i, turned; of small integers exact.
static double turned(const tf_pair *pair, int i)
{
    tf_differences differences;
    tf_pair_differences(pair, i, &differences);
    tf_value value = oracle_arithmetic.value(&differences);
    return tf_pair_orientation(pair, i) * ldexp(value.number, value.exponent);
}

/// The turned determinants are the barycentric coordinates of one point, up to
/// a factor: both operands have the same sums of weighted coordinates, of
/// times, and of weights.
static bool same_point(const tf_pair *pair)
{
    double difference[TF_AXES + 2] = {0};
    for (int i = 0; i < pair->count; i++) {
        double weight = pair->operand[i] * turned(pair, i);
        for (int k = 0; k < pair->axes; k++)
            difference[k] += weight * pair->event[i]->x[pair->axis[k]];
        difference[TF_AXES] += weight * pair->event[i]->t;
        difference[TF_AXES + 1] += weight;
    }
    for (int k = 0; k < TF_AXES + 2; k++)
        if (difference[k] != 0)
            return false;
    return true;
}

START_TEST(turned_determinants_are_coordinates_of_one_point)
{
    generator random = generator_new((uint64_t)_i);
    own_pair own = {.event = {{.t = 0}}};
    for (long i = 0; i < cases(3000); i++) {
        if (_i < SHAPES) {
            shape_moving(&own, _i);
        } else {
            int axes = 1 + below(&random, 3), first = 1 + below(&random, axes);
            shape_static(&own, axes, first, axes + 2 - first);
        }
        fill_lattice(&own, &random, 5);
        ck_assert_msg(same_point(&own.pair), "two points:\n%s",
                      pair_text(&own));
    }
}
END_TEST

// What is gathered ------------------------------------------------------------

/// Expect the signs up to the first conflict, and no more of them to be asked.
static void expect_signs(const own_pair *own)
{
    tf_arithmetic arithmetic = counting(&oracle_arithmetic);
    tf_signs found;
    find_signs(&arithmetic, &own->pair, &found);
    bool seen[3] = {false, false, false}; // by sign, from -1
    int i = 0;
    while (i < own->pair.count && !(seen[0] && seen[2])) {
        double coordinate = turned(&own->pair, i);
        int sign = (coordinate > 0) - (coordinate < 0);
        ck_assert_msg((int)found.sign[i] == sign, "sign %d is %d:\n%s", i,
                      (int)found.sign[i], pair_text(own));
        seen[sign + 1] = true;
        i++;
    }
    ck_assert_msg(found.negative == seen[0] && found.zero == seen[1] &&
                      found.positive == seen[2] && !found.unknown,
                  "other signs are seen:\n%s", pair_text(own));
    ck_assert_int_eq(counted().signs, i);
    ck_assert_int_eq(counted().values, 0);
}

START_TEST(signs_are_found_up_to_the_first_conflict)
{
    generator random = generator_new((uint64_t)(10 + _i));
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    for (long i = 0; i < cases(3000); i++) {
        fill_lattice(&own, &random, 2 + below(&random, 4));
        expect_signs(&own);
    }
}
END_TEST

static tf_sign no_sign(const tf_differences *differences)
{
    (void)differences;
    return TF_UNKNOWN;
}

START_TEST(unknown_signs_are_not_turned)
{
    tf_arithmetic ignorant = oracle_arithmetic;
    ignorant.sign = no_sign;
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, _i);
    tf_signs found;
    find_signs(&ignorant, &own.pair, &found);
    ck_assert(found.unknown && !found.zero && !found.positive &&
              !found.negative);
    for (int i = 0; i < own.pair.count; i++)
        ck_assert_int_eq(found.sign[i], TF_UNKNOWN);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/signs");
    TCase *tcase = tcase_create("signs");
    tcase_add_loop_test(tcase, turned_determinants_are_coordinates_of_one_point,
                        0, SHAPES + 1);
    tcase_add_loop_test(tcase, signs_are_found_up_to_the_first_conflict, 0,
                        SHAPES);
    tcase_add_loop_test(tcase, unknown_signs_are_not_turned, 0, SHAPES);
    suite_add_tcase(suite, tcase);
    return suite;
}
