#include "figures/numbers.h"

#include "kit/cloth_run.h"

START_TEST(only_one_strip_tangles)
{
    char *text = printed(&fig_twisted_strips);
    double first = number_of(text, "first_crossing");
    double steps = number_of(text, "steps");
    ck_assert_double_gt(first, 0);
    ck_assert_double_lt(first, number_of(text, "step"));
    ck_assert_double_le(number_of(text, "step"), steps);
    ck_assert_double_gt(number_of(text, "crossings"), 0);
    expect_number(text, "crossings_resolved", 0);
    free(text);
}
END_TEST

START_TEST(a_run_counts_every_intersection)
{
    const fig_cloth_plan plan = {
        .scene = "twist", .size = 3, .steps = 350, .check = 1};
    fig_cloth_plan other = plan;
    other.unresolved = true;
    const fig_cloth_run *run = fig_cloth_run_of(&plan);
    const fig_cloth_run *tangled = fig_cloth_run_of(&other);
    int found = 0;
    for (int i = 0; i <= plan.steps; i++) {
        ck_assert_int_eq(run->step[i].crossings, 0);
        found += tangled->step[i].crossings;
    }
    ck_assert_int_gt(found, 0);
    ck_assert_int_gt(fig_cloth_run_count(run, TF_ZONES), 0);
    ck_assert_int_eq(fig_cloth_run_count(tangled, TF_ZONES), 0);
    ck_assert_ptr_eq(fig_cloth_run_of(&plan), run);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/twisted_strips", only_one_strip_tangles);
    TCase *more = tcase_create("more");
    tcase_add_test(more, a_run_counts_every_intersection);
    suite_add_tcase(s, more);
    return s;
}
