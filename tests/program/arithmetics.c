#include "program/arithmetics.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "support/support.h"

START_TEST(every_arithmetic_is_found_by_its_own_name)
{
    static const tf_arithmetic *const all[] = {&tf_exact,     &tf_clamped,
                                               &tf_published, &tf_perturbed,
                                               &tf_integer64, &tf_integer128};
    for (int i = 0; i < 6; i++)
        ck_assert_ptr_eq(
            tf_choice_named(tf_arithmetics, tf_arithmetic_name(all[i])),
            all[i]);
}
END_TEST

START_TEST(integers_fit_below_a_power_of_two)
{
    const tf_arithmetic *integer = &tf_integer64;
    static const double limits[] = {0, 0, 0x1p30, 0x1p19};
    for (int axes = 2; axes <= 3; axes++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double limit = sign * limits[axes];
            ck_assert(tf_arithmetic_fits(integer, axes, limit - sign));
            ck_assert(!tf_arithmetic_fits(integer, axes, limit));
            ck_assert(!tf_arithmetic_fits(integer, axes, 0.5 * sign));
        }
    ck_assert(tf_arithmetic_fits(&tf_exact, 3, 1e308));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/arithmetics");
    TCase *names = tcase_create("names");
    tcase_add_test(names, every_arithmetic_is_found_by_its_own_name);
    tcase_add_test(names, integers_fit_below_a_power_of_two);
    suite_add_tcase(suite, names);
    return suite;
}
