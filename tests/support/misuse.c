#include "support/misuse.h"

#include "base/contract.h"
#include "base/describe.h"

#include <stdlib.h>

void expect_error(const char *call, unsigned status, unsigned expected,
                  const struct tf_error *error)
{
    char sentence[300];
    size_t length = tf_describe(error, sentence, sizeof sentence);
    ck_assert_msg(status == expected, "%s: \"%s\" and not \"%s\"", call,
                  tf_status_message((tf_status)status),
                  tf_status_message((tf_status)expected));
    ck_assert_msg(error->status == status, "%s: an error about \"%s\"", call,
                  tf_status_message(error->status));
    ck_assert_msg(length > 0 && length < sizeof sentence, "%s: no sentence",
                  call);
}

static const null_call *all;

enum {
    BROKEN = 7 // a status of exit
};

static void exit_at_broken_contract(const char *file, int line,
                                    const char *condition)
{
    (void)file;
    (void)line;
    (void)condition;
    exit(BROKEN);
}

START_TEST(a_null_pointer_breaks_the_contract)
{
    const null_call *one = all;
    int null = _i;
    for (; null >= one->pointers; one++)
        null -= one->pointers;
    tf_contract_set_handler(exit_at_broken_contract);
    one->call(null);
    ck_abort_msg("pointer %d of function %d may be null", null,
                 (int)(one - all));
}
END_TEST

void add_null_calls(TCase *c, const null_call calls[])
{
    int pointers = 0;
    for (all = calls; calls->call; calls++)
        pointers += calls->pointers;
    tcase_add_loop_exit_test(c, a_null_pointer_breaks_the_contract, BROKEN, 0,
                             pointers);
}
