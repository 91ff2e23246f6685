#include "figures/rows.h"

START_TEST(costs_are_those_measured)
{
    static const int triangles[] = {180, 980, 9680, 98000, 994580, 3996180};
    static const char *const cloths[] = {"dense", "sparse"};
    char *text = printed(&fig_finding_costs);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 2; j++) {
            char row[80], key[80];
            snprintf(row, sizeof row, "%s %d finding candidates", cloths[j],
                     triangles[i]);
            snprintf(key, sizeof key, "%s_time_%d", cloths[j], triangles[i]);
            expect_number(text, key, row_value(row));
            snprintf(row, sizeof row, "%s %d memory", cloths[j], triangles[i]);
            snprintf(key, sizeof key, "%s_memory_%d", cloths[j], triangles[i]);
            expect_number(text, key, row_value(row));
        }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/finding_costs", costs_are_those_measured);
}
