#include "base/environment.h"

#include "support/environments.h"
#include "support/support.h"

#include <fenv.h>

START_TEST(the_default_environment_is_accepted)
{
    ck_assert(tf_environment_is_ieee());
}
END_TEST

START_TEST(broken_environments_are_detected_and_left_unchanged)
{
    environment_break(_i);
    bool ieee = tf_environment_is_ieee(), left = environment_is_broken(_i);
    environment_restore();
    ck_assert_msg(!ieee, "%s passes for IEEE's", environment_name(_i));
    ck_assert_msg(left, "%s is changed", environment_name(_i));
    ck_assert_msg(tf_environment_is_ieee(), "%s stays", environment_name(_i));
}
END_TEST

START_TEST(raised_exceptions_do_not_count_as_broken)
{
    feraiseexcept(FE_INEXACT | FE_UNDERFLOW | FE_OVERFLOW);
    ck_assert(tf_environment_is_ieee());
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/environment");
    TCase *tcase = tcase_create("environment");
    tcase_add_test(tcase, the_default_environment_is_accepted);
    tcase_add_loop_test(tcase,
                        broken_environments_are_detected_and_left_unchanged, 0,
                        environments());
    tcase_add_test(tcase, raised_exceptions_do_not_count_as_broken);
    suite_add_tcase(suite, tcase);
    return suite;
}
