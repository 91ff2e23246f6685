#include "arithmetic/six.h"

#include "arithmetic/accumulated.h"
#include "support/six.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

/// Expect no wrong sign; returns how many are known.
static int judge(const six_events *six)
{
    const tf_event *list[TF_SIX];
    tf_sign sign[TF_SIX];
    int known = 0;
    six_list(six, list);
    tf_estimate_six(six->start_count, list, sign);
    for (int i = 0; i < TF_SIX; i++) {
        if (sign[i] == TF_UNKNOWN)
            continue;
        tf_differences d = six_without(six, i);
        tf_sign exact = tf_accumulated_sign(&d);
        ck_assert_msg(sign[i] == exact, "sign %d is %d, not %d, seed %llu:\n%s",
                      i, (int)sign[i], (int)exact, (unsigned long long)seed(),
                      six_text(six));
        known++;
    }
    return known;
}

static void scale(six_events *six, int axis, int exponent)
{
    for (int i = 0; i < TF_SIX; i++)
        six->event[i].x[axis] = ldexp(six->event[i].x[axis], exponent);
}

static six_events six_reals(generator *random)
{
    six_events six = {.start_count = 2 + below(random, 3)};
    for (int i = 0; i < TF_SIX; i++)
        for (int k = 0; k < TF_AXES; k++)
            six.event[i].x[k] = uniform(random, -1, 1);
    return six;
}

START_TEST(all_signs_of_random_reals_are_proved)
{
    generator random = generator_new(1);
    long count = cases(20000), known = 0;
    for (long i = 0; i < count; i++) {
        six_events six = six_reals(&random);
        int up = below(&random, 700), axis = below(&random, TF_AXES);
        scale(&six, axis, up);
        scale(&six, (axis + 1) % TF_AXES, -up);
        scale(&six, (axis + 2) % TF_AXES, below(&random, 400) - 200);
        known += judge(&six);
    }
    ck_assert_msg(known > TF_SIX * count * 999 / 1000, "%ld of %ld", known,
                  TF_SIX * count);
}
END_TEST

/// Expect no wrong sign, and a known one at least once in so many events, but
/// not always.
static void judge_many(generator *random, long count,
                       six_events (*make)(generator *random), int once_in)
{
    long known = 0;
    for (long i = 0; i < count; i++) {
        six_events six = make(random);
        known += judge(&six);
    }
    ck_assert_msg(once_in * known > TF_SIX * count &&
                      known < TF_SIX * count * 95 / 100,
                  "%ld of %ld", known, TF_SIX * count);
}

START_TEST(proved_signs_are_right)
{
    generator random = generator_new(2);
    judge_many(&random, cases(60000), six_any, 2);
}
END_TEST

START_TEST(proved_signs_near_a_plane_are_right)
{
    generator random = generator_new(3);
    judge_many(&random, cases(200000), six_flat, 100);
}
END_TEST

START_TEST(nothing_is_proved_where_products_may_overflow)
{
    generator random = generator_new(4);
    for (int i = 0; i < 1000; i++) {
        six_events six = six_reals(&random);
        int axis = below(&random, TF_AXES);
        scale(&six, axis, 510);
        scale(&six, (axis + 1) % TF_AXES, 510);
        scale(&six, (axis + 2) % TF_AXES, -below(&random, 1000));
        ck_assert_int_eq(judge(&six), 0);
    }
}
END_TEST

START_TEST(nothing_is_proved_where_products_may_underflow)
{
    generator random = generator_new(6);
    for (int i = 0; i < 1000; i++) {
        six_events six = six_reals(&random);
        int axis = below(&random, TF_AXES);
        scale(&six, axis, -460);
        scale(&six, (axis + 1) % TF_AXES, -460);
        scale(&six, (axis + 2) % TF_AXES, below(&random, 1000));
        ck_assert_int_eq(judge(&six), 0);
    }
}
END_TEST

START_TEST(the_largest_doubles_prove_nothing)
{
    static const double some[] = {-DBL_MAX, DBL_MAX, 0, 1, DBL_TRUE_MIN};
    generator random = generator_new(7);
    for (int i = 0; i < 20000; i++) {
        six_events six = six_reals(&random);
        for (int k = 0; k < TF_AXES; k++)
            for (int j = 0; j < TF_SIX && below(&random, 2); j++)
                six.event[j].x[k] = some[below(&random, 5)];
        judge(&six);
    }
}
END_TEST

START_TEST(underflow_is_not_mistaken_for_a_sign)
{
    generator random = generator_new(5);
    for (long i = cases(20000); i > 0; i--) {
        six_events six =
            below(&random, 2) ? six_any(&random) : six_flat(&random);
        for (int k = 0; k < TF_AXES; k++)
            scale(&six, k, -below(&random, 1070));
        judge(&six);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("arithmetic/six");
    TCase *tcase = tcase_create("estimates");
    tcase_add_test(tcase, all_signs_of_random_reals_are_proved);
    tcase_add_test(tcase, proved_signs_are_right);
    tcase_add_test(tcase, proved_signs_near_a_plane_are_right);
    tcase_add_test(tcase, nothing_is_proved_where_products_may_overflow);
    tcase_add_test(tcase, nothing_is_proved_where_products_may_underflow);
    tcase_add_test(tcase, the_largest_doubles_prove_nothing);
    tcase_add_test(tcase, underflow_is_not_mistaken_for_a_sign);
    suite_add_tcase(suite, tcase);
    return suite;
}
