#include "program/narrow_phases.h"

#include "fast/vectorized.h"
#include "support/support.h"

START_TEST(every_name_finds_its_narrow_phase)
{
    ck_assert_ptr_eq(tf_narrow_phase_named("reference"), &tf_reference);
    ck_assert_ptr_eq(tf_narrow_phase_named("vector"), &tf_vectorized);
    ck_assert_str_eq(TF_NARROW_PHASE_NAMES, "reference or vector");
}
END_TEST

START_TEST(other_names_find_nothing)
{
    static const char *const names[] = {"", "vectors", "Vector", "reference "};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ck_assert_msg(!tf_narrow_phase_named(names[i]), "'%s'", names[i]);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/narrow_phases");
    TCase *names = tcase_create("names");
    tcase_add_test(names, every_name_finds_its_narrow_phase);
    tcase_add_test(names, other_names_find_nothing);
    suite_add_tcase(suite, names);
    return suite;
}
