#include "figures/numbers.h"

START_TEST(fair_triangles_have_no_small_angle)
{
    char *text = printed(&fig_quality_angles);
    // The cotangent of 30 degrees times 3/2 and half of its tangent add up to
    // the root of 3 over 0.6.
    ck_assert_double_eq_tol(number_of(text, "high"), 30, 1e-9);
    double low = number_of(text, "low") * acos(-1) / 180;
    ck_assert_double_eq_tol(1 / tan(low) + 2 * tan(low / 2), sqrt(3) / 0.6,
                            1e-9);
    double turn = number_of(text, "turn") * acos(-1) / 180;
    ck_assert_double_eq_tol(hypot(1 - cos(turn), sin(turn)), 0.5, 1e-9);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/quality_angles",
                    fair_triangles_have_no_small_angle);
}
