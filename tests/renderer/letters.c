#include "renderer/letters.h"

#include "support/support.h"

#include <math.h>

/// Set text; the width and height of its ink.
static void measure(const char *text, double size, double ink[4])
{
    fig_letters *letters;
    ck_assert_int_eq(fig_letters_set(FIG_LETTERS_FAMILY, text, size, &letters),
                     FIG_OK);
    fig_letters_ink(letters, &ink[0], &ink[1], &ink[2], &ink[3]);
    fig_letters_free(letters);
}

START_TEST(unknown_font_families_are_detected)
{
    ck_assert(fig_letters_known(FIG_LETTERS_FAMILY));
    ck_assert(!fig_letters_known("No Such Family"));
    ck_assert(!fig_letters_known(""));
}
END_TEST

START_TEST(bad_text_is_refused)
{
    const char *const bad[] = {"$x",   "$x_{i$", "$\\bar{x$", "\xff\xfe",
                               "a *b", "$x_$",   "\\",        "$\\alpha$"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        fig_letters *letters;
        ck_assert_msg(fig_letters_set(FIG_LETTERS_FAMILY, bad[i], 10,
                                      &letters) == FIG_BAD_TEXT,
                      "%s", bad[i]);
        ck_assert_ptr_null(letters);
    }
}
END_TEST

START_TEST(special_characters_can_be_quoted)
{
    double ink[4], plain[4];
    measure("\\$\\*\\\\", 10, ink);
    ck_assert_double_gt(ink[2], 5);
    measure("a_b^c", 10, plain);
    measure("$a_b^c$", 10, ink);
    ck_assert_double_lt(ink[2], plain[2]);
}
END_TEST

START_TEST(letters_start_a_path_of_their_own)
{
    fig_letters *letters;
    ck_assert_int_eq(fig_letters_set(FIG_LETTERS_FAMILY, "$x$", 10, &letters),
                     FIG_OK);
    cairo_surface_t *picture =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 20, 20);
    cairo_t *cairo = cairo_create(picture);
    fig_letters_draw(letters, cairo, 5, 15, (fig_rgb){0, 0, 0});
    ck_assert(!cairo_has_current_point(cairo));
    cairo_destroy(cairo);
    cairo_surface_destroy(picture);
    fig_letters_free(letters);
}
END_TEST

START_TEST(size_scales_letters)
{
    double small[4], large[4];
    measure("$x_0'$ at 1", 10, small);
    measure("$x_0'$ at 1", 40, large);
    for (int k = 0; k < 4; k++)
        ck_assert_double_eq_tol(large[k], 4 * small[k], 0.5);
}
END_TEST

START_TEST(bars_and_scripts_add_height)
{
    double plain[4], bar[4], low[4], high[4];
    measure("$x$", 20, plain);
    measure("$\\bar{x}$", 20, bar);
    measure("$x_0$", 20, low);
    measure("$x^2$", 20, high);
    ck_assert_double_lt(bar[1], plain[1] - 1);
    ck_assert_double_gt(low[1] + low[3], plain[1] + plain[3] + 1);
    ck_assert_double_lt(high[1], plain[1] - 1);
}
END_TEST

START_TEST(primes_stand_over_subscripts)
{
    double low[4], both[4], after[4];
    measure("$x_0$", 20, low);
    measure("$x_0'$", 20, both);
    ck_assert_double_lt(both[1], low[1] - 1);
    ck_assert_double_eq_tol(both[1] + both[3], low[1] + low[3], 0.01);
    ck_assert_double_eq_tol(both[2], low[2], 1);

    // What follows stays where it was.
    measure("$x_0 y$", 20, low);
    measure("$x_0' y$", 20, both);
    ck_assert_double_eq_tol(both[2], low[2], 0.01);

    // In \bar and behind other letters too.
    measure("$ab + \\bar{x_{ij}} y$", 20, low);
    measure("$ab + \\bar{x_{ij}'} y$", 20, after);
    ck_assert_double_eq_tol(after[2], low[2], 0.01);
}
END_TEST

START_TEST(empty_text_has_no_ink)
{
    double ink[4];
    measure("", 10, ink);
    ck_assert_double_eq(ink[2], 0);
    ck_assert_double_eq(ink[3], 0);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/letters");
    TCase *tests = tcase_create("letters");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, unknown_font_families_are_detected);
    tcase_add_test(tests, bad_text_is_refused);
    tcase_add_test(tests, special_characters_can_be_quoted);
    tcase_add_test(tests, letters_start_a_path_of_their_own);
    tcase_add_test(tests, size_scales_letters);
    tcase_add_test(tests, bars_and_scripts_add_height);
    tcase_add_test(tests, primes_stand_over_subscripts);
    tcase_add_test(tests, empty_text_has_no_ink);
    return made;
}
