#include "renderer/theme.h"

#include "support/support.h"

#include <math.h>
#include <stddef.h>

/// What is left of a color (linear light) to eyes with all receptors, and
/// with those for long, middle or short waves missing: Machado, Oliveira and
/// Fernandes, "A Physiologically-based Model for Simulation of Color Vision
/// Deficiency", 2009, at full severity.
static const double sights[4][3][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                       {{0.152286, 1.052583, -0.204868},
                                        {0.114503, 0.786281, 0.099216},
                                        {-0.003882, -0.048116, 1.051998}},
                                       {{0.367322, 0.860646, -0.227968},
                                        {0.280085, 0.672501, 0.047413},
                                        {-0.011820, 0.042940, 0.968881}},
                                       {{1.255528, -0.076749, -0.178779},
                                        {-0.078411, 0.930809, 0.147602},
                                        {0.004733, 0.691367, 0.303900}}};

static const fig_theme *const themes[] = {&fig_theme_light, &fig_theme_dark};

static void to_linear(fig_rgb color, double light[3])
{
    light[0] = fig_rgb_to_linear(color.r);
    light[1] = fig_rgb_to_linear(color.g);
    light[2] = fig_rgb_to_linear(color.b);
}

/// The ratio of luminances that accessibility guidelines ask for.
static double contrast(fig_rgb a, fig_rgb b)
{
    double x[3], y[3];
    to_linear(a, x);
    to_linear(b, y);
    double p = 0.2126 * x[0] + 0.7152 * x[1] + 0.0722 * x[2] + 0.05;
    double q = 0.2126 * y[0] + 0.7152 * y[1] + 0.0722 * y[2] + 0.05;
    return fmax(p, q) / fmin(p, q);
}

/// Ottosson's Oklab, in which distances are about as they are seen.
static void to_lab(const double light[3], double lab[3])
{
    static const double to_cones[3][3] = {
        {0.4122214708, 0.5363325363, 0.0514459929},
        {0.2119034982, 0.6806995451, 0.1073969566},
        {0.0883024619, 0.2817188376, 0.6299787005}};
    static const double from_cones[3][3] = {
        {0.2104542553, 0.7936177850, -0.0040720468},
        {1.9779984951, -2.4285922050, 0.4505937099},
        {0.0259040371, 0.7827717662, -0.8086757660}};
    double cone[3] = {0};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            cone[i] += to_cones[i][k] * light[k];
        cone[i] = cbrt(fmax(cone[i], 0));
    }
    for (int i = 0; i < 3; i++) {
        lab[i] = 0;
        for (int k = 0; k < 3; k++)
            lab[i] += from_cones[i][k] * cone[k];
    }
}

static double seen_distance(const double sight[3][3], fig_rgb a, fig_rgb b)
{
    double light[2][3], seen[2][3] = {{0}}, lab[2][3];
    to_linear(a, light[0]);
    to_linear(b, light[1]);
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                seen[c][i] += sight[i][k] * light[c][k];
        to_lab(seen[c], lab[c]);
    }
    return sqrt(pow(lab[0][0] - lab[1][0], 2) + pow(lab[0][1] - lab[1][1], 2) +
                pow(lab[0][2] - lab[1][2], 2));
}

START_TEST(lines_and_letters_stand_off_the_paper)
{
    const fig_theme *theme = themes[_i];
    fig_rgb paper = theme->color[FIG_ROLE_PAPER];
    for (int role = FIG_ROLE_NEUTRAL; role <= FIG_ROLE_END; role++) {
        double ratio = contrast(theme->color[role], paper);
        ck_assert_msg(ratio >= 2.9, "%s, role %d: %g", theme->name, role,
                      ratio);
    }
    ck_assert_double_ge(contrast(theme->color[FIG_ROLE_INK], paper), 12);
}
END_TEST

START_TEST(letters_stand_off_the_map_of_signs)
{
    const fig_theme *theme = themes[_i];
    fig_rgb ink = theme->color[FIG_ROLE_INK];
    ck_assert_double_ge(contrast(theme->color[FIG_ROLE_POSITIVE], ink), 4);
    ck_assert_double_ge(contrast(theme->color[FIG_ROLE_NEGATIVE], ink), 3.5);
}
END_TEST

static void check_pair(const fig_theme *theme, int a, int b, double least)
{
    for (int sight = 0; sight < 4; sight++) {
        double distance =
            seen_distance(sights[sight], theme->color[a], theme->color[b]);
        ck_assert_msg(distance > least, "%s, roles %d and %d, sight %d: %g",
                      theme->name, a, b, sight, distance);
    }
}

START_TEST(roles_of_geometry_differ_for_color_blind_readers)
{
    for (int a = FIG_ROLE_POINT; a <= FIG_ROLE_END; a++)
        for (int b = a + 1; b <= FIG_ROLE_END; b++)
            check_pair(themes[_i], a, b, 0.04);
}
END_TEST

START_TEST(signs_differ_for_color_blind_readers)
{
    for (int a = FIG_ROLE_POSITIVE; a <= FIG_ROLE_UNCERTAIN; a++)
        for (int b = a + 1; b <= FIG_ROLE_UNCERTAIN; b++)
            check_pair(themes[_i], a, b, 0.1);
}
END_TEST

START_TEST(themes_are_found_by_name)
{
    ck_assert_ptr_eq(fig_theme_named("light"), &fig_theme_light);
    ck_assert_ptr_eq(fig_theme_named("dark"), &fig_theme_dark);
    ck_assert_ptr_null(fig_theme_named("Light"));
    ck_assert_ptr_null(fig_theme_named(""));
}
END_TEST

START_TEST(the_encoding_of_colors_is_undone)
{
    for (int i = 0; i <= 255; i++) {
        double x = i / 255.0;
        ck_assert_double_eq_tol(fig_rgb_from_linear(fig_rgb_to_linear(x)), x,
                                1e-9);
    }
    ck_assert_double_eq_tol(fig_rgb_to_linear(0.5), 0.21404114, 1e-8);
}
END_TEST

START_TEST(shades_go_to_ink_and_to_paper)
{
    const fig_theme *theme = &fig_theme_light;
    fig_paint ink = {.role = FIG_ROLE_EDGE, .shade = 1};
    fig_paint paper = {.role = FIG_ROLE_EDGE, .shade = -1};
    fig_paint half = {.role = FIG_ROLE_EDGE, .shade = -0.5};
    double edge = theme->color[FIG_ROLE_EDGE].r;
    ck_assert_double_eq_tol(fig_paint_color(theme, ink).r,
                            theme->color[FIG_ROLE_INK].r, 1e-12);
    ck_assert_double_eq_tol(fig_paint_color(theme, paper).r, 1, 1e-12);
    ck_assert_double_eq_tol(fig_paint_color(theme, half).r, (1 + edge) / 2,
                            1e-12);
    ck_assert_double_eq(fig_paint_opacity(half), 1);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/theme");
    TCase *tests = tcase_create("theme");
    suite_add_tcase(made, tests);
    tcase_add_loop_test(tests, lines_and_letters_stand_off_the_paper, 0, 2);
    tcase_add_loop_test(tests, letters_stand_off_the_map_of_signs, 0, 2);
    tcase_add_loop_test(tests, roles_of_geometry_differ_for_color_blind_readers,
                        0, 2);
    tcase_add_loop_test(tests, signs_differ_for_color_blind_readers, 0, 2);
    tcase_add_test(tests, themes_are_found_by_name);
    tcase_add_test(tests, the_encoding_of_colors_is_undone);
    tcase_add_test(tests, shades_go_to_ink_and_to_paper);
    return made;
}
