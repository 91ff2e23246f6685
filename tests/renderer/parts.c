#include "renderer/page_parts.h"
#include "renderer/plot.h"
#include "support/support.h"

#include <math.h>

static fig_page *new_page(void)
{
    const fig_page_options options = {
        .width = 300, .height = 200, .pixels_x = 300, .pixels_y = 200};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    return page;
}

static void add_text(fig_page *page, double x, double y, const char *text)
{
    fig_page_text(page, x, y, FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

/// Two panels side by side, the left one last, with a caption each, one for
/// both, an axis at the left, and a plot below them; a label and a dot in each
/// panel.
static fig_page *page_of_three(fig_panel *panel[2])
{
    static const fig_box box[2] = {{160, 20, 120, 80}, {30, 20, 120, 80}};
    fig_page *page = new_page();
    fig_page_panel(page, (fig_box){0, 20, 25, 80});
    for (int i = 0; i < 2; i++) {
        panel[i] = fig_page_panel(page, box[i]);
        fig_scene_ball(fig_panel_scene(panel[i]), (tf_vector){{0}},
                       FIG_WIDTH_BALL, (fig_paint){.role = FIG_ROLE_POINT});
        fig_panel_label(panel[i], (tf_vector){{0}}, (fig_label){.text = "a"});
        fig_page_dot(page, box[i].x + 30, box[i].y + 40, 4, (fig_paint){0});
        fig_page_caption(page, box[i], i == 0 ? "right" : "left");
    }
    fig_plot_frame(page, &(fig_plot){.box = {60, 140, 80, 50},
                                     .x = {0, 1},
                                     .y = {0, 1},
                                     .ticks_x = -1,
                                     .ticks_y = -1});
    add_text(page, 150, 125, "what both panels above show together");
    return page;
}

static int texts_of(const fig_page *page)
{
    int texts = 0;
    for (int i = 0; i < page->mark_count; i++)
        texts += page->marks[i].kind == FIG_MARK_TEXT;
    return texts;
}

/// The box of the i-th text.
static fig_box caption_of(const fig_page *page, int i)
{
    int at = 0;
    while (page->marks[at].kind != FIG_MARK_TEXT || i-- > 0)
        at++;
    return fig_mark_text_box(&page->marks[at]);
}

// Parts -----------------------------------------------------------------------

START_TEST(parts_are_numbered_in_reading_order)
{
    static const double left[] = {30, 160, 60};
    fig_panel *panel[2];
    fig_page *page = page_of_three(panel);
    ck_assert_int_eq(fig_page_parts(page), 3);
    for (int i = 0; i < 3; i++) {
        fig_box box = fig_page_part(page, i);
        ck_assert_msg(box.x < left[i] && box.x > left[i] - 10,
                      "part %d begins at %g", i, box.x);
    }
    fig_page_free(page);
}
END_TEST

START_TEST(overlapping_panels_are_one_part)
{
    fig_page *page = new_page();
    ck_assert_int_eq(fig_page_parts(page), 0);
    fig_page_panel(page, (fig_box){0, 0, 100, 100});
    fig_page_panel(page, (fig_box){150, 0, 100, 100});
    ck_assert_int_eq(fig_page_parts(page), 2);
    fig_page_panel(page, (fig_box){60, 0, 120, 100});
    ck_assert_int_eq(fig_page_parts(page), 1);
    fig_page_free(page);
}
END_TEST

static void expect_box(fig_box found, fig_box box)
{
    ck_assert_double_eq(found.y, box.y);
    ck_assert_double_eq(found.height, box.height);
    ck_assert_double_eq(found.x, box.x);
    ck_assert_double_eq(found.width, box.width);
}

START_TEST(texts_belong_to_the_nearest_part)
{
    fig_page *page = new_page();
    fig_page_panel(page, (fig_box){50, 50, 100, 50});
    double low = 100 + 5, high = 50 - 5;
    add_text(page, 100, 116, "below");
    fig_box box = fig_page_part(page, 0);
    ck_assert_double_gt(box.y + box.height, low + 9);
    ck_assert_double_eq(box.y, high);
    add_text(page, 100, 40, "above");
    ck_assert_double_lt(fig_page_part(page, 0).y, high - 5);

    // What is far off, or too wide, or nearer to another one, is none of it.
    box = fig_page_part(page, 0);
    add_text(page, 100, 150, "far off");
    add_text(page, 150, 112, "what is much too wide for a single panel");
    expect_box(fig_page_part(page, 0), box);
    fig_page_panel(page, (fig_box){50, 128, 100, 50});
    add_text(page, 100, 126, "near");
    expect_box(fig_page_part(page, 0), box);
    fig_page_free(page);
}
END_TEST

// Cropping --------------------------------------------------------------------

START_TEST(a_part_has_its_own_texts_and_labels)
{
    for (int i = 0; i < 3; i++) {
        fig_panel *panel[2];
        fig_page *page = page_of_three(panel);
        fig_page_crop(page, fig_page_part(page, i));
        ck_assert_int_eq(texts_of(page), i < 2);
        ck_assert_int_eq(fig_page_labels(page), i < 2);
        fig_page_free(page);
    }
}
END_TEST

/// Panels, places of texts, but not their letters.
START_TEST(a_small_part_is_magnified)
{
    fig_panel *panel[2];
    fig_page *page = page_of_three(panel);
    fig_box part = fig_page_part(page, 0);
    fig_box shown = fig_page_crop(page, part);
    double scale = shown.width / part.width;
    ck_assert_double_gt(scale, 1.5);
    ck_assert_double_eq_tol(fmax(shown.width, shown.height), 256, 1e-9);
    ck_assert_double_eq_tol(shown.height, scale * part.height, 1e-9);
    ck_assert(shown.x == 0 && shown.y == 0);
    ck_assert_double_eq_tol(panel[1]->box.x, scale * (30 - part.x), 1e-9);
    ck_assert_double_eq_tol(panel[1]->box.width, scale * 120, 1e-9);
    ck_assert_double_eq_tol(panel[1]->margin, scale * FIG_FIT_MARGIN, 1e-9);

    fig_page *whole = page_of_three(panel);
    fig_box text[2] = {caption_of(whole, 1), caption_of(page, 0)};
    ck_assert_double_eq_tol(text[1].width, text[0].width, 1e-9);
    ck_assert_double_eq_tol(text[1].x + text[1].width / 2,
                            scale * (text[0].x + text[0].width / 2 - part.x),
                            1e-9);
    fig_page_free(whole);
    fig_page_free(page);
}
END_TEST

START_TEST(a_large_part_keeps_its_size)
{
    fig_page *page = new_page();
    fig_page_panel(page, (fig_box){0, 0, 300, 100});
    fig_box shown = fig_page_crop(page, fig_page_part(page, 0));
    ck_assert_double_eq(shown.width, 310);
    fig_page_free(page);
}
END_TEST

// Headings and labels ---------------------------------------------------------

START_TEST(a_heading_makes_room_above)
{
    fig_page *page = new_page();
    fig_raster before = fig_page_raster(page);
    fig_page_heading(page, "A heading");
    double height = fig_page_heading_height((fig_box){0, 0, 300, 200});
    ck_assert_double_gt(height, 10);
    fig_raster after = fig_page_raster(page);
    ck_assert_double_eq_tol(after.scale, 200 / (200 + height), 1e-12);
    ck_assert_int_eq(after.shift_y, (int)(height * after.scale));
    ck_assert_int_gt(after.shift_x, before.shift_x);
    fig_page_free(page);
}
END_TEST

START_TEST(a_long_heading_fits)
{
    fig_page *page = new_page();
    fig_page_heading(page, "short");
    double width = fig_letters_advance(page->heading);
    fig_page_heading(page, "a heading of so many words that in letters of the "
                           "usual size it would be wider than the page");
    double most = fig_letters_advance(page->heading);
    ck_assert_msg(most > 0.9 * 300 && most <= 300, "%g points wide", most);
    ck_assert_double_lt(width, 100);
    fig_page_free(page);
}
END_TEST

START_TEST(bare_pages_have_no_labels)
{
    fig_page_options options = {.width = 100,
                                .height = 100,
                                .pixels_x = 50,
                                .pixels_y = 50,
                                .bare = true};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    fig_page_label(page, 50, 50, (fig_label){.text = "a"});
    add_text(page, 50, 50, "b");
    ck_assert_int_eq(fig_page_labels(page), 0);
    ck_assert_int_eq(texts_of(page), 1);
    fig_page_free(page);
}
END_TEST

// Sheets in one plane ---------------------------------------------------------

/// Two triangles of a slanting plane that overlap and share no corner: where
/// they do, the picture is as without the second, which has another color,
/// though the rounding of their depths differs.
START_TEST(sheets_in_a_plane_have_no_speckles)
{
    enum {
        SIDE = 64
    };
    static const double at[2][3][2] = {{{-2, -1.1}, {2.3, -1}, {0.1, 2}},
                                       {{-1.7, 0.9}, {0.2, -1.3}, {2, 1}}};
    static uint32_t pixels[2][SIDE * SIDE];
    for (int count = 1; count <= 2; count++) {
        // In a film nothing fades with the distance.
        fig_page_options options = {.width = 64,
                                    .height = 64,
                                    .pixels_x = SIDE,
                                    .pixels_y = SIDE,
                                    .moves = true};
        fig_page *page;
        ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
        fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 64, 64});
        for (int i = 0; i < count; i++) {
            tf_vector corner[3];
            for (int k = 0; k < 3; k++)
                corner[k] =
                    (tf_vector){{at[i][k][0], at[i][k][1],
                                 0.37 * at[i][k][0] + 0.61 * at[i][k][1]}};
            fig_scene_triangle(
                fig_panel_scene(panel), corner, 0,
                (fig_paint){i == 0 ? FIG_ROLE_EDGE : FIG_ROLE_CONTACT, 0.5, 0});
        }
        fig_panel_look(panel, (fig_camera){.azimuth = 28,
                                           .elevation = 24,
                                           .distance = 9,
                                           .height = 2});
        ck_assert_int_eq(fig_page_paint(page, pixels[count - 1]), FIG_OK);
        fig_page_free(page);
    }
    // In the middle both are seen.
    for (int y = 24; y < 40; y++)
        for (int x = 24; x < 40; x++)
            ck_assert_msg(
                pixels[0][SIDE * y + x] == pixels[1][SIDE * y + x],
                "the pixel (%d, %d) is %x with one sheet and %x with both", x,
                y, (unsigned)pixels[0][SIDE * y + x],
                (unsigned)pixels[1][SIDE * y + x]);
}
END_TEST

/// A sheet that is not flat has no plane.
START_TEST(curved_sheets_are_drawn)
{
    static const double height[] = {0, 1, 0};
    static uint32_t pixels[32 * 32];
    const fig_page_options options = {
        .width = 64, .height = 64, .pixels_x = 32, .pixels_y = 32};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 64, 64});
    tf_vector at[6];
    for (int i = 0; i < 6; i++)
        at[i] = (tf_vector){{i % 3 - 1, i / 3, height[i % 3]}};
    fig_scene_patch(fig_panel_scene(panel), 2, 3, at, 0,
                    (fig_paint){FIG_ROLE_EDGE, 0.5, 0});
    fig_panel_look(panel, (fig_camera){.elevation = 50});
    ck_assert_int_eq(fig_page_paint(page, pixels), FIG_OK);
    ck_assert_uint_ne(pixels[32 * 16 + 16] & 0xffffff, pixels[0] & 0xffffff);
    fig_page_free(page);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/parts");
    TCase *tests = tcase_create("parts");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, parts_are_numbered_in_reading_order);
    tcase_add_test(tests, overlapping_panels_are_one_part);
    tcase_add_test(tests, texts_belong_to_the_nearest_part);
    tcase_add_test(tests, a_part_has_its_own_texts_and_labels);
    tcase_add_test(tests, a_small_part_is_magnified);
    tcase_add_test(tests, a_large_part_keeps_its_size);
    tcase_add_test(tests, a_heading_makes_room_above);
    tcase_add_test(tests, a_long_heading_fits);
    tcase_add_test(tests, bare_pages_have_no_labels);
    tcase_add_test(tests, sheets_in_a_plane_have_no_speckles);
    tcase_add_test(tests, curved_sheets_are_drawn);
    return made;
}
