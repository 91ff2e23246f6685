#include "figures/pages.h"
#include "support/picture_folder.h"
#include "support/support.h"

#include "renderer/box.h"

#include <cairo.h>
#include <stdio.h>
#include <string.h>

// What is right about a page --------------------------------------------------

static void expect_labels(const fig_figure *figure, const fig_page *page)
{
    // Bounds of boxes are rounded.
    const double slack = 1e-6;
    for (int i = 0; i < fig_page_labels(page); i++) {
        fig_box box = fig_page_placed(page, i).box;
        ck_assert_msg(box.x >= -slack && box.y >= -slack &&
                          box.x + box.width <= figure->width + slack &&
                          box.y + box.height <= figure->height + slack,
                      "%s: label %d leaves the page", figure->name, i);
        for (int j = 0; j < i; j++) {
            fig_box other = fig_page_placed(page, j).box;
            ck_assert_msg(fig_box_overlap(&box, &other) <= slack,
                          "%s: label %d is on label %d", figure->name, i, j);
        }
    }
}

/// Expect that some pixels differ from the one in the corner.
static void expect_drawn(const fig_figure *figure, int width, int height)
{
    cairo_surface_t *surface =
        cairo_image_surface_create_from_png(picture_path());
    ck_assert_int_eq(cairo_image_surface_get_width(surface), width);
    ck_assert_int_eq(cairo_image_surface_get_height(surface), height);
    const unsigned char *row = cairo_image_surface_get_data(surface),
                        *paper = row;
    int other = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++)
            other += memcmp(row + 4 * (size_t)x, paper, 3) != 0;
        row += cairo_image_surface_get_stride(surface);
    }
    ck_assert_msg(other > width * height / 100,
                  "%s: of %d x %d pixels only %d are not paper", figure->name,
                  width, height, other);
    cairo_surface_destroy(surface);
}

static void expect_figure(const fig_figure *figure, int width, int height,
                          const fig_theme *theme)
{
    fig_page_options options = {
        .pixels_x = width, .pixels_y = height, .theme = theme};
    fig_page *page = draw_figure(figure, options, NULL);
    fig_status status = fig_page_write(page, picture_path());
    ck_assert_msg(status == FIG_OK, "%s: %s", figure->name,
                  fig_status_message(status));
    expect_labels(figure, page);
    expect_drawn(figure, width, height);
    fig_page_free(page);
}

// Tests -----------------------------------------------------------------------

/// Whether a figure simulates whole scenes first, which takes seconds, or under
/// sanitizers minutes.
static bool takes_long(const fig_figure *figure)
{
    static const char *const names[] = {"fallen-cloth", "pulled-cloth",
                                        "enright-volume", "twisted-strips",
                                        "flow-scenes"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(figure->name, names[i]) == 0)
            return true;
    return false;
}

/// With a TF_TEST_PERCENT below 100, at one size, and without what takes long:
/// scenes are simulated by other tests, and other figures draw cloth, too.
START_TEST(figure_is_drawn_at_any_size_in_either_theme)
{
    static const int size[3][2] = {{64, 48}, {120, 120}, {240, 180}};
    const fig_figure *figure = fig_figures[_i];
    if (cases(100) < 100 && takes_long(figure))
        return;
    for (int i = 0; i < (int)cases(3); i++)
        expect_figure(figure, size[i][0], size[i][1],
                      i % 2 ? &fig_theme_light : &fig_theme_dark);
}
END_TEST

/// Where a figure's labels are, all added up, when it is turned.
static double place_labels(const fig_figure *figure, double azimuth)
{
    fig_page_options options = {.pixels_x = 120,
                                .pixels_y = 120,
                                .turned = true,
                                .azimuth = azimuth,
                                .elevation = 22};
    fig_page *page = draw_figure(figure, options, NULL);
    ck_assert_int_eq(fig_page_write(page, picture_path()), FIG_OK);
    expect_labels(figure, page);
    double sum = 0;
    for (int i = 0; i < fig_page_labels(page); i++)
        sum += fig_page_placed(page, i).box.x;
    fig_page_free(page);
    return sum;
}

START_TEST(solids_turn)
{
    static const char *const solid[] = {"edge-sweep",  "prism",
                                        "bent-slices", "sheared-frame",
                                        "contact",     "edge-edge-distances"};
    for (size_t i = 0; i < sizeof solid / sizeof *solid; i++) {
        const fig_figure *figure = fig_figure_named(solid[i]);
        double before = place_labels(figure, 30);
        ck_assert_msg(place_labels(figure, 120) != before, "%s", figure->name);
        ck_assert_double_eq(place_labels(figure, 30), before);
    }
}
END_TEST

/// What leaves the page is cut at its border.  Bands may reach there; letters,
/// chips and arrows may not.
START_TEST(layers_stay_on_the_page)
{
    int width = 768, height = (int)(768 * fig_layers.height / fig_layers.width);
    expect_figure(&fig_layers, width, height, &fig_theme_light);
    cairo_surface_t *surface =
        cairo_image_surface_create_from_png(picture_path());
    const unsigned char *data = cairo_image_surface_get_data(surface);
    int stride = cairo_image_surface_get_stride(surface);
    for (int i = 0; i < width * height; i++) {
        int x = i % width, y = i / width;
        if (x == 0 || y == 0 || x == width - 1 || y == height - 1)
            ck_assert_msg(data[(ptrdiff_t)y * stride + 4 * x + 1] > 220,
                          "(%d, %d) is on the border", x, y);
    }
    cairo_surface_destroy(surface);
}
END_TEST

START_TEST(names_find_figures)
{
    for (int i = 0; fig_figures[i]; i++)
        ck_assert_ptr_eq(fig_figure_named(fig_figures[i]->name),
                         fig_figures[i]);
    ck_assert_ptr_null(fig_figure_named(""));
    ck_assert_ptr_null(fig_figure_named("no-such-figure"));
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("figures/all");
    TCase *drawn = tcase_create("drawn");
    tcase_add_checked_fixture(drawn, make_picture_folder,
                              remove_picture_folder);
    tcase_add_loop_test(drawn, figure_is_drawn_at_any_size_in_either_theme, 0,
                        count_figures());
    tcase_add_test(drawn, solids_turn);
    tcase_add_test(drawn, layers_stay_on_the_page);
    suite_add_tcase(s, drawn);
    tcase_add_test(drawn, names_find_figures);
    return s;
}
