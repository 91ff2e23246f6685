#define _POSIX_C_SOURCE 200112L // setenv

#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    // A slow day is no failure: 0 is no time limit.
    setenv("CK_DEFAULT_TIMEOUT", "0", 1);
    printf("seed %llu\n", (unsigned long long)seed());
    fflush(stdout); // before tests fork

    SRunner *runner = srunner_create(suite());
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
