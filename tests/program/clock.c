#define _GNU_SOURCE // usleep

#include "program/clock.h"

#include "support/support.h"

#include <unistd.h>

START_TEST(time_passes_in_seconds)
{
    double before = tf_clock_seconds();
    usleep(20000);
    double passed = tf_clock_seconds() - before;
    ck_assert_msg(passed >= 0.02 && passed < 20, "%g seconds", passed);
}
END_TEST

START_TEST(it_never_goes_back)
{
    double before = tf_clock_seconds();
    for (int i = 0; i < 10000; i++) {
        double now = tf_clock_seconds();
        ck_assert_double_ge(now, before);
        before = now;
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/clock");
    TCase *clock = tcase_create("clock");
    tcase_add_test(clock, time_passes_in_seconds);
    tcase_add_test(clock, it_never_goes_back);
    suite_add_tcase(suite, clock);
    return suite;
}
