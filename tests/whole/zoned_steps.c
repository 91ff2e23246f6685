// Steps from tangled starts: outside of their zones everything stays clear, and
// a weaker rule is found out.
#include "support/zoned_steps.h"

#include "support/support.h"

#include <check.h>

START_TEST(steps_stay_clear_outside_of_zones)
{
    zoned_counts counts = {0};
    for (long number = 0, wanted = cases_at_least(300, 300);
         counts.steps < wanted; number++) {
        const char *fault = zoned_fault(number, false, &counts);
        ck_assert_msg(!fault, "%s", fault);
    }
    zoned_counts_print(&counts);
    ck_assert_int_gt(counts.pairs, 1000 * counts.steps);
    ck_assert_int_gt(2 * counts.met, counts.steps);
    ck_assert(counts.refused > 0 && counts.rescued > 0 && counts.exact > 0);
}
END_TEST

START_TEST(a_weaker_rule_is_found_out)
{
    zoned_counts counts = {0};
    for (long number = 0, wanted = cases_at_least(100, 100);
         counts.steps < wanted; number++)
        zoned_fault(number, true, &counts);
    zoned_counts_print(&counts);
    ck_assert_int_gt(10 * counts.faulty, counts.steps);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/zoned_steps");
    TCase *tcase = tcase_create("steps");
    tcase_add_test(tcase, steps_stay_clear_outside_of_zones);
    tcase_add_test(tcase, a_weaker_rule_is_found_out);
    suite_add_tcase(suite, tcase);
    return suite;
}
