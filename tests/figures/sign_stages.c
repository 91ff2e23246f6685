#include "figures/numbers.h"
#include "measured.h"

/// The numbers of a workload are its row, which adds up to all queries but for
/// rounding.
static void expect_row(const char *text, const tf_stage_share *row)
{
    static const char *const stages[TF_STAGE_SHARES] = {"none", "estimate",
                                                        "accumulator"};
    const char *kind = strcmp(row->kind, "edge-edge") == 0 ? "ee" : "pt";
    char key[80];
    double sum = 0;
    for (int i = 0; i < TF_STAGE_SHARES; i++) {
        snprintf(key, sizeof key, "%s_%s_%s", row->work, kind, stages[i]);
        expect_number(text, key, row->percent[i]);
        sum += row->percent[i];
    }
    snprintf(key, sizeof key, "%s_%s_tails", row->work, kind);
    expect_number(text, key, row->tails);
    snprintf(key, sizeof key, "%s_%s_heads", row->work, kind);
    expect_number(text, key, row->heads);
    ck_assert_msg(fabs(sum - 100) < 0.01, "%s, %s: %g percent", row->work,
                  row->kind, sum);
}

START_TEST(numbers_are_those_measured)
{
    static const char *const keys[] = {
        "ns_estimate",           "ns_whole",     "ns_accumulator",
        "ns_any_size",           "ns_expansion", "ns_integers",
        "ns_expansion_integers", "ns_plane",     "ns_expansion_plane"};
    int rows, stages;
    const tf_stage_share *share = tf_measured_shares(&rows);
    const tf_stage_time *timed = tf_measured_stages(&stages);
    char *text = printed(&tf_figure_sign_stages);
    ck_assert_int_gt(rows, 0);
    for (int i = 0; i < rows; i++)
        expect_row(text, &share[i]);
    ck_assert_int_eq(stages, (int)(sizeof keys / sizeof *keys));
    for (int i = 0; i < stages; i++)
        expect_number(text, keys[i], timed[i].time);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sign_stages", numbers_are_those_measured);
}
