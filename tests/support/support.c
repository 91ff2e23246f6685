#include "support/support.h"

#include <stdlib.h>

long cases(long full)
{
    const char *told = getenv("TF_TEST_PERCENT");
    double percent = told ? strtod(told, NULL) : 100;
    double scaled = (double)full * percent / 100;
    return scaled >= 1 ? (long)scaled : 1;
}

long cases_at_least(long least, long full)
{
    long some = cases(full);
    return some >= least ? some : least;
}
