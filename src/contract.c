//: Include what contracts need
#include "contract.h"

#include <stdio.h>
#include <stdlib.h>

//: Tell what a status means
static const char *const messages[] = {
    [TF_OK] = "no error",
    [TF_NOT_FINITE] = "a coordinate is not a finite number: mend the input "
                      "(NaN or infinity)",
    [TF_OUT_OF_RANGE] = "out of range: a coordinate is not an integer of the "
                        "bits that this arithmetic holds; use exact",
};

const char *tf_status_message(tf_status status)
{
    TF_REQUIRE((unsigned)status < sizeof messages / sizeof *messages);
    return messages[status];
}

//: Report a broken contract
static void print_broken(const char *file, int line, const char *condition)
{
    fprintf(stderr, "%s:%d: broken contract: %s\n", file, line, condition);
}

static tf_contract_handler *handler = print_broken;

tf_contract_handler *tf_contract_set_handler(tf_contract_handler *replacement)
{
    tf_contract_handler *before = handler;
    handler = replacement ? replacement : print_broken;
    return before;
}

void tf_contract_broken(const char *file, int line, const char *condition)
{
    handler(file, line, condition);
    abort();
}

//: Test the floating-point environment
bool tf_environment_is_ieee(void)
{
    // Volatile, so that the test runs in the caller's environment, not in the
    // compiler's.
    volatile double tiny = 0x1p-60, smallest_normal = DBL_MIN;
    volatile double next = DBL_MIN + DBL_TRUE_MIN;

    // Any rounding but to nearest tells 1 + tiny from 1 - tiny.
    bool to_nearest = 1 + tiny == 1 - tiny;
    bool keeps_subnormals = next - smallest_normal != 0;
    return to_nearest && keeps_subnormals;
}
