#include "figures/numbers.h"
#include "measured.h"

START_TEST(numbers_are_those_measured)
{
    int count;
    const tf_query_time *timed = tf_measured_queries(&count);
    char *text = printed(&tf_figure_sign_costs);
    ck_assert_int_gt(count, 0);
    for (int i = 0; i < count; i++) {
        char key[80];
        snprintf(key, sizeof key, "%s_%s_%s", timed[i].work,
                 strcmp(timed[i].kind, "edge-edge") == 0 ? "ee" : "pt",
                 timed[i].arithmetic);
        expect_number(text, key, timed[i].time);
        size_t length = strlen(key);
        strcpy(key + length, "_hits");
        expect_number(text, key, (double)timed[i].hits);
        strcpy(key + length, "_queries");
        expect_number(text, key, (double)timed[i].queries);
        ck_assert_double_gt(timed[i].time, 0);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sign_costs", numbers_are_those_measured);
}
