#include "figures/numbers.h"

#include "kit/random.h"

enum {
    QUERIES = 32768,
    VERTICES = 4
};

/// The share of queries whose first element of `first` vertices an axis
/// separates from the second, in percent, of those that the figure makes.
static double percent_separated(int first, double size)
{
    uint64_t random = 15;
    int count = 0;
    for (int i = 0; i < QUERIES; i++) {
        double corner[3], x[2][VERTICES][3];
        for (int k = 0; k < 3; k++)
            corner[k] = (1 - size) * fig_random_number(&random);
        for (int v = 0; v < VERTICES; v++)
            for (int k = 0; k < 3; k++) {
                x[0][v][k] = corner[k] + size * fig_random_number(&random);
                x[1][v][k] =
                    x[0][v][k] + 0.2 * fig_random_number(&random) - 0.1;
            }
        bool separated = false;
        for (int k = 0; k < 3; k++) {
            bool below = true, above = true;
            for (int t = 0; t < 2; t++)
                for (int a = 0; a < first; a++)
                    for (int b = first; b < VERTICES; b++) {
                        below &= x[t][a][k] < x[t][b][k];
                        above &= x[t][a][k] > x[t][b][k];
                    }
            separated |= below | above;
        }
        count += separated;
    }
    return 100.0 * count / QUERIES;
}

START_TEST(shares_are_those_of_separated_queries)
{
    char *text = printed(&fig_early_outs);
    expect_number(text, "pt_soup_1", percent_separated(1, 1));
    expect_number(text, "ee_soup_1", percent_separated(2, 1));
    expect_number(text, "pt_near_1", percent_separated(1, 0.1));
    expect_number(text, "ee_near_1", percent_separated(2, 0.1));
    free(text);
}
END_TEST

START_TEST(neighbors_in_a_sheet_agree)
{
    static const char *const kinds[] = {"pt", "ee"};
    char *text = printed(&fig_early_outs);
    for (int i = 0; i < 2; i++)
        for (int lanes = 2; lanes <= 64; lanes *= 2) {
            char key[48], before[48];
            snprintf(key, sizeof key, "%s_sheet_%d", kinds[i], lanes);
            snprintf(before, sizeof before, "%s_sheet_%d", kinds[i], lanes / 2);
            double share = number_of(text, key);
            ck_assert_double_lt(share, number_of(text, before));
            snprintf(key, sizeof key, "%s_sheet_mixed_%d", kinds[i], lanes);
            ck_assert_double_gt(share, number_of(text, key));
            snprintf(before, sizeof before, "%s_sheet_1", kinds[i]);
            expect_number(text, key,
                          100 * pow(number_of(text, before) / 100, lanes));
        }
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s =
        suite_of("figures/early_outs", shares_are_those_of_separated_queries);
    TCase *sheet = tcase_create("sheet");
    tcase_add_test(sheet, neighbors_in_a_sheet_agree);
    suite_add_tcase(s, sheet);
    return s;
}
