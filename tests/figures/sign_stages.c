#include "figures/numbers.h"
#include "measured.h"

/// The numbers of a workload are its row, which adds up to all queries but for
/// rounding.
static void expect_row(const char *text, const tf_stage_share *row)
{
    static const char *const stages[TF_STAGE_SHARES] = {
        "none", "estimate", "expansion", "accumulator"};
    double sum = 0;
    for (int i = 0; i < TF_STAGE_SHARES; i++) {
        char key[80];
        snprintf(key, sizeof key, "%s_%s_%s", row->work,
                 strcmp(row->kind, "edge-edge") == 0 ? "ee" : "pt", stages[i]);
        expect_number(text, key, row->percent[i]);
        sum += row->percent[i];
    }
    ck_assert_msg(fabs(sum - 100) < 0.01, "%s, %s: %g percent", row->work,
                  row->kind, sum);
}

START_TEST(numbers_are_those_measured)
{
    static const char *const keys[] = {"ns_estimate", "ns_expansion",
                                       "ns_accumulator", "ns_any_size"};
    int rows, stages;
    const tf_stage_share *share = tf_measured_shares(&rows);
    const tf_stage_time *timed = tf_measured_stages(&stages);
    char *text = printed(&tf_figure_sign_stages);
    ck_assert_int_gt(rows, 0);
    for (int i = 0; i < rows; i++)
        expect_row(text, &share[i]);
    ck_assert_int_eq(stages, 4);
    for (int i = 0; i < stages; i++)
        expect_number(text, keys[i], timed[i].time);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sign_stages", numbers_are_those_measured);
}
