#include "figures/numbers.h"

#include "kit/measured.h"

START_TEST(angles_grow)
{
    static const char *const meshes[] = {"clamp", "piston", "fitting"};
    char *text = printed(&fig_angle_histograms);
    int bins = (int)number_of(text, "bins");
    for (int i = 0; i < 3; i++) {
        double before = 0, after = 0;
        for (int bin = 0; bin < bins; bin++) {
            before += fig_measured("remeshing %s before %d", meshes[i], bin);
            after += fig_measured("remeshing %s after %d", meshes[i], bin);
        }
        ck_assert_double_eq_tol(before, 100, 0.01);
        ck_assert_double_eq_tol(after, 100, 0.01);
        ck_assert_double_lt(fig_measured("remeshing %s thin", meshes[i]), 3);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/angle_histograms", angles_grow);
}
