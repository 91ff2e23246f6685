// Responses, judged by what shares no code with detection.
#include "support/resolving.h"
#include "support/support.h"

#include <stdio.h>

// Random proposals ------------------------------------------------------------

START_TEST(random_proposals_are_resolved)
{
    resolving_counts counts = {0};
    long tries = cases(600);
    for (long number = 0; number < tries; number++) {
        const char *fault = numbered_fault(number, &counts);
        ck_assert_msg(!fault, "%s", fault);
    }
    printf("%ld proposals: %ld with contacts, %ld by the failsafe, %ld held "
           "back, %ld put to rest, %ld judged on the way, %d rounds at most\n",
           counts.tries, counts.met, counts.rescued, counts.held, counts.rested,
           counts.exact, counts.rounds);
    ck_assert_int_ge(10 * counts.tries, 9 * tries);
    ck_assert_int_ge(2 * counts.met, tries);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/response");
    TCase *random = tcase_create("random proposals");
    tcase_add_test(random, random_proposals_are_resolved);
    suite_add_tcase(suite, random);
    return suite;
}
