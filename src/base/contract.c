//: Include what contracts need
#include "base/contract.h"

#include "base/require.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

//: Report a broken contract
static void print_broken(const char *file, int line, const char *condition)
{
    fprintf(stderr, "%s:%d: broken contract: %s\n", file, line, condition);
}

static _Atomic(tf_contract_handler *) handler = print_broken;

tf_contract_handler *tf_contract_set_handler(tf_contract_handler *replacement)
{
    return atomic_exchange(&handler, replacement ? replacement : print_broken);
}

void tf_contract_broken(const char *file, int line, const char *condition)
{
    atomic_load (&handler)(file, line, condition);
    abort();
}
