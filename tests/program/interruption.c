#include "program/interruption.h"

#include "support/support.h"

#include <signal.h>

// Each test is a process of its own.
static const int requests[] = {SIGINT, SIGTERM, SIGHUP};

START_TEST(a_request_waits)
{
    signal(requests[_i], SIG_DFL); // nohup ignores SIGHUP
    tf_interruption_hold();
    ck_assert_int_eq(tf_interruption(), 0);
    raise(requests[_i]);
    ck_assert_int_eq(tf_interruption(), requests[_i]);
    ck_assert_int_eq(tf_interruption(), requests[_i]);
}
END_TEST

START_TEST(what_is_ignored_requests_nothing)
{
    signal(SIGINT, SIG_IGN);
    tf_interruption_hold();
    raise(SIGINT);
    ck_assert_int_eq(tf_interruption(), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/interruption");
    TCase *tcase = tcase_create("signals");
    tcase_add_loop_test(tcase, a_request_waits, 0, 3);
    tcase_add_test(tcase, what_is_ignored_requests_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
