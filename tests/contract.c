#include "contract.h"

#include "support/support.h"

#include <fenv.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

START_TEST(every_status_has_a_message)
{
    for (int status = TF_OK; status <= TF_OUT_OF_RANGE; status++)
        ck_assert_uint_gt(strlen(tf_status_message((tf_status)status)), 5);
    ck_assert_ptr_nonnull(
        strstr(tf_status_message(TF_OUT_OF_RANGE), "out of range"));
}
END_TEST

START_TEST(unknown_status_breaks_the_contract)
{
    tf_status_message((tf_status)99);
}
END_TEST

START_TEST(kept_contract_passes)
{
    TF_REQUIRE(1 + 1 == 2);
}
END_TEST

static void exit_with_line(const char *file, int line, const char *condition)
{
    bool told = strstr(file, "contract.c") && strcmp(condition, "1 > 2") == 0;
    exit(told && line > 0 ? 7 : 1);
}

START_TEST(handler_is_told_place_and_condition)
{
    tf_contract_set_handler(exit_with_line);
    TF_REQUIRE(1 > 2);
}
END_TEST

static void return_quietly(const char *file, int line, const char *condition)
{
    (void)file, (void)line, (void)condition;
}

START_TEST(handler_that_returns_does_not_go_on)
{
    tf_contract_set_handler(return_quietly);
    TF_REQUIRE(1 > 2);
}
END_TEST

START_TEST(null_restores_the_default_handler)
{
    tf_contract_handler *initial = tf_contract_set_handler(return_quietly);
    ck_assert(tf_contract_set_handler(NULL) == return_quietly);
    ck_assert(tf_contract_set_handler(NULL) == initial);
}
END_TEST

START_TEST(environment_is_ieee)
{
    ck_assert(tf_environment_is_ieee());
}
END_TEST

START_TEST(directed_rounding_is_seen)
{
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    fesetround(modes[_i]);
    bool ieee = tf_environment_is_ieee();
    fesetround(FE_TONEAREST);
    ck_assert_msg(!ieee, "rounding mode %d passes for nearest", modes[_i]);
}
END_TEST

#ifdef __SSE__
START_TEST(flushed_subnormals_are_seen)
{
    unsigned before = _mm_getcsr();
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    bool ieee = tf_environment_is_ieee();
    _mm_setcsr(before);
    ck_assert(!ieee);
}
END_TEST
#endif

Suite *suite(void)
{
    Suite *suite = suite_create("contract");
    TCase *tcase = tcase_create("contract");
    tcase_add_test(tcase, every_status_has_a_message);
    tcase_add_test_raise_signal(tcase, unknown_status_breaks_the_contract,
                                SIGABRT);
    tcase_add_test(tcase, kept_contract_passes);
    tcase_add_exit_test(tcase, handler_is_told_place_and_condition, 7);
    tcase_add_test_raise_signal(tcase, handler_that_returns_does_not_go_on,
                                SIGABRT);
    tcase_add_test(tcase, null_restores_the_default_handler);
    tcase_add_test(tcase, environment_is_ieee);
    tcase_add_loop_test(tcase, directed_rounding_is_seen, 0, 3);
#ifdef __SSE__
    tcase_add_test(tcase, flushed_subnormals_are_seen);
#endif
    suite_add_tcase(suite, tcase);
    return suite;
}
