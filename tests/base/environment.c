#include "base/environment.h"

#include "support/environments.h"
#include "support/support.h"

#include <fenv.h>

START_TEST(environment_is_ieee)
{
    ck_assert(tf_environment_is_ieee());
}
END_TEST

START_TEST(broken_environments_are_seen_and_left_alone)
{
    environment_break(_i);
    bool ieee = tf_environment_is_ieee(), left = environment_is_broken(_i);
    environment_restore();
    ck_assert_msg(!ieee, "%s passes for IEEE's", environment_name(_i));
    ck_assert_msg(left, "%s is changed", environment_name(_i));
    ck_assert_msg(tf_environment_is_ieee(), "%s stays", environment_name(_i));
}
END_TEST

START_TEST(raised_exceptions_do_no_harm)
{
    feraiseexcept(FE_INEXACT | FE_UNDERFLOW | FE_OVERFLOW);
    ck_assert(tf_environment_is_ieee());
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/environment");
    TCase *tcase = tcase_create("environment");
    tcase_add_test(tcase, environment_is_ieee);
    tcase_add_loop_test(tcase, broken_environments_are_seen_and_left_alone, 0,
                        environments());
    tcase_add_test(tcase, raised_exceptions_do_no_harm);
    suite_add_tcase(suite, tcase);
    return suite;
}
