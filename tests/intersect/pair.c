#include "intersect/pair.h"

#include "support/pairs.h"
#include "support/support.h"

#include <signal.h>

START_TEST(differences_are_taken_within_each_time)
{
    own_pair own = {.event = {{.t = 0}}};
    shape_moving(&own, 1);
    tf_differences d;
    tf_pair_differences(&own.pair, 1, &d);
    ck_assert_int_eq(d.n, 2);
    for (int i = 0; i < 2; i++) {
        ck_assert_ptr_eq(d.to[i], &own.event[3 + i]);
        ck_assert_ptr_eq(d.from[i], &own.event[2]);
    }
}
END_TEST

START_TEST(a_pair_sorts_events_by_time)
{
    tf_worldline vertex[4] = {{.at = {{.t = 0}, {.t = 1}}}};
    for (int i = 1; i < 4; i++)
        vertex[i] = vertex[0];
    tf_simplex s[1], r[3];
    tf_sweep(1, vertex, s);
    tf_sweep(3, vertex + 1, r);
    tf_pair pair = tf_pair_of(&s[0], &r[1], 3);
    static const int operands[] = {+1, -1, -1, +1, -1, -1};
    ck_assert_int_eq(pair.count, 6);
    ck_assert_int_eq(pair.start_count, 3);
    for (int i = 0; i < 6; i++) {
        ck_assert_int_eq(pair.event[i]->t, i >= 3);
        ck_assert_int_eq(pair.operand[i], operands[i]);
    }
}
END_TEST

START_TEST(a_pair_that_is_not_complementary_breaks_the_contract)
{
    tf_worldline vertex = {.at = {{.t = 0}, {.t = 1}}};
    tf_simplex s[1];
    tf_sweep(1, &vertex, s);
    tf_pair_of(&s[0], &s[0], 3);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/pair");
    TCase *tcase = tcase_create("pair");
    tcase_add_test(tcase, differences_are_taken_within_each_time);
    tcase_add_test(tcase, a_pair_sorts_events_by_time);
    tcase_add_test_raise_signal(
        tcase, a_pair_that_is_not_complementary_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
