#define _POSIX_C_SOURCE 200112L // getpid

#include "renderer/plot.h"

#include "support/support.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static const fig_plot plot = {.box = {50, 10, 100, 60},
                              .x = {-1, 1},
                              .y = {1, 1000},
                              .log_y = true,
                              .name_x = "$x$",
                              .name_y = "time"};

START_TEST(positions_are_in_proportion)
{
    fig_point at = fig_plot_place(&plot, -1, 1);
    ck_assert_double_eq_tol(at.x, 50, 1e-9);
    ck_assert_double_eq_tol(at.y, 70, 1e-9);
    at = fig_plot_place(&plot, 0.5, 100);
    ck_assert_double_eq_tol(at.x, 125, 1e-9);
    ck_assert_double_eq_tol(at.y, 30, 1e-9);
}
END_TEST

/// How many pixels of a page's picture are dark in columns 0..9 of ten.
static void count_ink(fig_page *page, int ink[10])
{
    char path[256];
    const char *directory = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/tanglefree-plot-%ld.png",
             directory != NULL ? directory : "/tmp", (long)getpid());
    ck_assert_int_eq(fig_page_write(page, path), FIG_OK);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    remove(path);
    int width = cairo_image_surface_get_width(picture);
    int stride = cairo_image_surface_get_stride(picture);
    const unsigned char *bytes = cairo_image_surface_get_data(picture);
    for (int y = 0; y < cairo_image_surface_get_height(picture); y++)
        for (int x = 0; x < width; x++)
            ink[10 * x / width] += bytes[y * stride + 4 * x] < 128;
    cairo_surface_destroy(picture);
}

START_TEST(curves_are_cut_to_the_box)
{
    const fig_page_options options = {
        .width = 200, .height = 100, .pixels_x = 400, .pixels_y = 200};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    // Leaves the box to the left, comes back from above, leaves to the right.
    const fig_point at[] = {
        {0, 10}, {-9, 10}, {-0.5, 1e9}, {-0.5, 30}, {9, 30}};
    fig_plot_curve(page, &plot, 5, at, (fig_stroke){.width = 2});
    int ink[10] = {0};
    count_ink(page, ink);
    ck_assert_int_eq(ink[0] + ink[1], 0);
    ck_assert_int_gt(ink[3], 100);
    ck_assert_int_gt(ink[6], 100);
    ck_assert_int_eq(ink[8] + ink[9], 0);
    fig_page_free(page);
}
END_TEST

START_TEST(dots_are_drawn_at_their_positions)
{
    const fig_page_options options = {
        .width = 200, .height = 100, .pixels_x = 400, .pixels_y = 200};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    fig_point at = fig_plot_dot(page, &plot, -1, 10, 18, FIG_ROLE_INK);
    ck_assert_double_eq_tol(at.x, 50, 1e-9);
    ck_assert_double_eq_tol(at.y, 50, 1e-9);
    int ink[10] = {0};
    count_ink(page, ink);
    // A disc of 18 pixels' radius, in the third column.
    ck_assert_double_eq_tol(ink[2], 324 * acos(-1), 60);
    for (int i = 0; i < 10; i++)
        ck_assert(i == 2 || ink[i] == 0);
    fig_page_free(page);
}
END_TEST

START_TEST(frames_have_a_title_and_numbers)
{
    const fig_page_options options = {
        .width = 200, .height = 110, .pixels_x = 400, .pixels_y = 220};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    fig_plot_frame(page, &plot);
    int ink[10] = {0};
    count_ink(page, ink);
    ck_assert_int_gt(ink[0] + ink[1], 100); // numbers and the name beside
    ck_assert_int_eq(ink[9], 0);
    fig_page_free(page);
}
END_TEST

START_TEST(digits_are_in_groups)
{
    static const struct {
        long number;
        const char *text;
    } cases[] = {{0, "0"},
                 {-7, "-7"},
                 {999, "999"},
                 {1000, "1,000"},
                 {-11972, "-11,972"},
                 {200009, "200,009"},
                 {1234567, "1,234,567"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[FIG_GROUPED];
        fig_plot_grouped(cases[i].number, text);
        ck_assert_str_eq(text, cases[i].text);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/plot");
    TCase *tests = tcase_create("plot");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, positions_are_in_proportion);
    tcase_add_test(tests, curves_are_cut_to_the_box);
    tcase_add_test(tests, dots_are_drawn_at_their_positions);
    tcase_add_test(tests, frames_have_a_title_and_numbers);
    tcase_add_test(tests, digits_are_in_groups);
    return made;
}
