#include "figures/rows.h"

static double part(const char *text, const char *cloth, const char *name)
{
    char key[64];
    snprintf(key, sizeof key, "%s_%s", cloth, name);
    return number_of(text, key);
}

static double row(const char *cloth, int triangles, const char *name)
{
    char text[96];
    snprintf(text, sizeof text, "%s %d %s", cloth, triangles, name);
    return row_value(text);
}

static void expect_parts(const char *text, const char *cloth, int triangles)
{
    double trees = part(text, cloth, "trees"),
           joins = part(text, cloth, "joins"),
           deciding = part(text, cloth, "deciding"),
           describing = part(text, cloth, "describing");
    ck_assert_double_eq_tol(trees, row(cloth, triangles, "boxes and trees"),
                            1e-9);
    ck_assert_double_eq_tol(trees + joins,
                            row(cloth, triangles, "finding candidates"), 1e-9);
    ck_assert_double_eq_tol(trees + joins + deciding + describing,
                            row(cloth, triangles, "finding contacts"), 1e-9);
    ck_assert_double_eq_tol(describing,
                            row(cloth, triangles, "describing contacts"), 1e-9);
    ck_assert_double_gt(joins, 0);
    ck_assert_double_gt(deciding, 0);
}

START_TEST(parts_add_up_to_what_was_measured)
{
    char *text = printed(&fig_detection_costs);
    expect_parts(text, "sparse", 994580);
    expect_parts(text, "dense", 994580);
    expect_parts(text, "crowded", 98000);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/detection_costs",
                    parts_add_up_to_what_was_measured);
}
