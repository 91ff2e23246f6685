#include "figures/rows.h"

START_TEST(roofs_are_those_measured)
{
    static const char *const kind[] = {"point-triangle", "edge-edge"};
    static const char *const letters[] = {"pt", "ee"};
    static const char *const way[][2] = {{"vector", "vector"},
                                         {"streaming", "filter streaming"},
                                         {"cache", "filter in cache"}};
    char *text = printed(&fig_query_roofline), key[64], row[64];
    double read = row_value("read near point-triangle");
    expect_number(text, "read", read);
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 3; j++) {
            snprintf(key, sizeof key, "%s_%s", letters[i], way[j][0]);
            snprintf(row, sizeof row, "%s near %s", way[j][1], kind[i]);
            expect_number(text, key, row_value(row));
        }
        snprintf(key, sizeof key, "%s_balance", letters[i]);
        snprintf(row, sizeof row, "filter in cache near %s", kind[i]);
        expect_number(text, key, 192 * row_value(row) / read);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/query_roofline", roofs_are_those_measured);
}
