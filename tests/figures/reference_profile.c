#include "figures/rows.h"

static void expect_work(const char *text, const char *work, const char *kind,
                        const char *letters)
{
    static const char *const part[][2] = {{"reference", "reference"},
                                          {"vector", "vector"},
                                          {"filter", "filter streaming"}};
    char key[64], row[64];
    for (int i = 0; i < 3; i++) {
        snprintf(key, sizeof key, "%s_%s_%s", work, letters, part[i][0]);
        snprintf(row, sizeof row, "%s %s %s", part[i][1], work, kind);
        expect_number(text, key, row_value(row));
    }
    snprintf(row, sizeof row, "exact %s %s pairs", work, kind);
    double signs = row_value(row) * row_value("six estimates");
    snprintf(key, sizeof key, "%s_%s_signs", work, letters);
    expect_number(text, key, signs);
    snprintf(row, sizeof row, "reference %s %s", work, kind);
    snprintf(key, sizeof key, "%s_%s_share", work, letters);
    expect_number(text, key, 100 * signs / row_value(row));
    ck_assert_double_lt(number_of(text, key), 40);
}

START_TEST(parts_are_those_measured)
{
    char *text = printed(&fig_reference_profile);
    expect_work(text, "soup", "point-triangle", "pt");
    expect_work(text, "soup", "edge-edge", "ee");
    expect_work(text, "near", "point-triangle", "pt");
    expect_work(text, "near", "edge-edge", "ee");
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/reference_profile", parts_are_those_measured);
}
