#define _GNU_SOURCE // strtok_r

#include "program/arithmetics.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "support/support.h"

#include <string.h>

START_TEST(every_name_finds_its_arithmetic)
{
    ck_assert_ptr_eq(tf_arithmetic_named("exact"), &tf_exact);
    ck_assert_ptr_eq(tf_arithmetic_named("clamped"), &tf_clamped);
    ck_assert_ptr_eq(tf_arithmetic_named("report"), &tf_published);
    ck_assert_ptr_eq(tf_arithmetic_named("perturbed"), &tf_perturbed);
    ck_assert_ptr_eq(tf_arithmetic_named("integer64"), &tf_integer64);
    ck_assert_ptr_eq(tf_arithmetic_named("integer128"), &tf_integer128);
}
END_TEST

START_TEST(the_names_told_are_those_found)
{
    char names[] = TF_ARITHMETIC_NAMES;
    int found = 0;
    char *rest = names;
    for (char *name; (name = strtok_r(rest, ", ", &rest));)
        if (strcmp(name, "or") != 0) {
            ck_assert_msg(tf_arithmetic_named(name), "no '%s'", name);
            found++;
        }
    ck_assert_int_eq(found, 6);
}
END_TEST

START_TEST(other_names_find_nothing)
{
    static const char *const names[] = {"", "rounded", "Exact", "exact "};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ck_assert_msg(!tf_arithmetic_named(names[i]), "'%s'", names[i]);
}
END_TEST

START_TEST(coordinates_that_fit)
{
    const tf_arithmetic *integer = tf_arithmetic_named("integer64");
    static const double limits[] = {0, 0, 0x1p30, 0x1p19};
    for (int axes = 2; axes <= 3; axes++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double limit = sign * limits[axes];
            ck_assert(tf_arithmetic_fits(integer, axes, limit - sign));
            ck_assert(!tf_arithmetic_fits(integer, axes, limit));
            ck_assert(!tf_arithmetic_fits(integer, axes, 0.5 * sign));
        }
    ck_assert(tf_arithmetic_fits(tf_arithmetic_named("exact"), 3, 1e308));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/arithmetics");
    TCase *names = tcase_create("names");
    tcase_add_test(names, every_name_finds_its_arithmetic);
    tcase_add_test(names, the_names_told_are_those_found);
    tcase_add_test(names, other_names_find_nothing);
    tcase_add_test(names, coordinates_that_fit);
    suite_add_tcase(suite, names);
    return suite;
}
