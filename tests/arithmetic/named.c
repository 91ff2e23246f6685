#include "arithmetic/named.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "support/support.h"

#include <signal.h>

static const struct {
    const char *name;
    const tf_arithmetic *arithmetic;
} all[] = {
    {"exact", &tf_exact},         {"clamped", &tf_clamped},
    {"report", &tf_published},    {"perturbed", &tf_perturbed},
    {"integer64", &tf_integer64}, {"integer128", &tf_integer128},
};

START_TEST(names_are_those_of_the_command_line)
{
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        ck_assert_ptr_eq(tf_arithmetic_named(all[i].name), all[i].arithmetic);
        ck_assert_str_eq(tf_arithmetic_name(all[i].arithmetic), all[i].name);
    }
}
END_TEST

START_TEST(other_names_are_not)
{
    static const char *const others[] = {"", "exac", "exactly", "EXACT", "x"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        ck_assert_ptr_null(tf_arithmetic_named(others[i]));
}
END_TEST

START_TEST(no_name_breaks_the_contract)
{
    tf_arithmetic_named(NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("arithmetic/named");
    TCase *tcase = tcase_create("named");
    tcase_add_test(tcase, names_are_those_of_the_command_line);
    tcase_add_test(tcase, other_names_are_not);
    tcase_add_test_raise_signal(tcase, no_name_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
