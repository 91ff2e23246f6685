// What every test file starts from: Check, a reproducible source of random
// numbers, and the number of random cases to try.  main() is in main.c and runs
// the suite that the test file defines.
#ifndef SUPPORT_SUPPORT_H
#define SUPPORT_SUPPORT_H

#include "support/generator.h"

#include <check.h>

/// The suite of the test file.  No test has a time limit.
Suite *suite(void);

/// How many of `full` cases to try: TF_TEST_PERCENT (environment, 100 unless
/// told) percent of them, at least one.
long cases(long full);

/// The same, but at least `least`: for cases of which a number must be tried
/// until each kind has had its turn.
long cases_at_least(long least, long full);

#endif
