#define _POSIX_C_SOURCE 200112L // symlink

#include "stage/page.h"

#include "stage/placement.h"
#include "support/support.h"

#include <cairo.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const tf_page_options usual = {
    .width = 120, .height = 90, .pixels_x = 240, .pixels_y = 180};

static tf_page *new_page(const tf_page_options *options)
{
    tf_page *page;
    ck_assert_int_eq(tf_page_new(options, &page), TF_STAGE_OK);
    return page;
}

/// A name of its own in the directory for such files.
static void name_file(char path[256], const char *ending)
{
    const char *directory = getenv("TMPDIR");
    snprintf(path, 256, "%s/tanglefree-stage-%ld%s",
             directory != NULL ? directory : "/tmp", (long)getpid(), ending);
}

/// The bytes of a file, which is removed.
static size_t take_file(const char *path, unsigned char **bytes)
{
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    rewind(file);
    *bytes = malloc((size_t)size + 1);
    ck_assert_ptr_nonnull(*bytes);
    ck_assert_uint_eq(fread(*bytes, 1, (size_t)size, file), (size_t)size);
    fclose(file);
    remove(path);
    return (size_t)size;
}

static size_t write_page(tf_page *page, const char *ending,
                         unsigned char **bytes)
{
    char path[256];
    name_file(path, ending);
    ck_assert_int_eq(tf_page_write(page, path), TF_STAGE_OK);
    return take_file(path, bytes);
}

/// The page as pixels, read back from a PNG file.
static cairo_surface_t *picture_of(tf_page *page)
{
    char path[256];
    name_file(path, ".png");
    ck_assert_int_eq(tf_page_write(page, path), TF_STAGE_OK);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    ck_assert_int_eq(cairo_surface_status(picture), CAIRO_STATUS_SUCCESS);
    remove(path);
    return picture;
}

static void pixel_of(cairo_surface_t *picture, int x, int y, int rgb[3])
{
    unsigned pixel;
    memcpy(&pixel,
           cairo_image_surface_get_data(picture) +
               y * cairo_image_surface_get_stride(picture) + 4 * x,
           4);
    for (int k = 0; k < 3; k++)
        rgb[k] = (int)(pixel >> (16 - 8 * k) & 255);
}

/// A page with all kinds of things on it.
static tf_page *full_page(const tf_theme *theme)
{
    tf_page_options options = usual;
    options.theme = theme;
    tf_page *page = new_page(&options);
    tf_panel *panel = tf_page_panel(page, (tf_box){0, 0, 120, 80});
    tf_scene *scene = tf_panel_scene(panel);
    const double corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const char *const axis[3] = {"$x$", "$y$", "$t$"};
    tf_scene_tetrahedron(scene, corner, TF_WIDTH_THIN,
                         (tf_paint){TF_ROLE_TRIANGLE, 0.4, 0});
    tf_scene_ball(scene, corner[3], TF_WIDTH_BALL,
                  (tf_paint){.role = TF_ROLE_POINT});
    tf_scene_worldline(scene, corner[1], corner[3], TF_WIDTH_TUBE,
                       (tf_paint){.role = TF_ROLE_POINT});
    tf_scene_dashes(scene, corner[2], corner[3], TF_WIDTH_LINE, 3,
                    (tf_paint){.role = TF_ROLE_EDGE});
    tf_scene_grid(scene, corner[0], corner[1], corner[2], 4, 4, TF_ROLE_START);
    tf_panel_axes(panel, (double[]){-0.2, -0.2, 0}, (double[]){1, 1, 1.4},
                  axis);
    tf_panel_look(panel,
                  (tf_camera){.azimuth = 25, .elevation = 20, .distance = 8});
    for (int i = 0; i < 4; i++)
        tf_panel_label(panel, corner[i], (tf_label){.text = "$\\bar{p}_0$"});
    tf_page_text(page, 60, 88, TF_ALIGN_CENTER, "a caption", TF_LETTERS_SMALL,
                 TF_ROLE_INK);
    return page;
}

/// A red sheet and a blue one, each half the page high and more, that cross
/// in depth when seen from the front: y is how far behind a sheet is.
static void middle_of_sheets(double red_y, double blue_y, int rgb[3])
{
    tf_page *page = new_page(&usual);
    tf_panel *panel = tf_page_panel(page, (tf_box){0, 0, 120, 90});
    const double y[2] = {red_y, blue_y};
    const tf_role role[2] = {TF_ROLE_CONTACT, TF_ROLE_EDGE};
    for (int i = 0; i < 2; i++) {
        const double corner[3][3] = {
            {-9, y[i], -9}, {9, y[i], -9}, {0, y[i], 9}};
        tf_scene_triangle(tf_panel_scene(panel), corner, 0,
                          (tf_paint){role[i], 0.7, 0});
    }
    tf_panel_look(panel, (tf_camera){.height = 9});
    cairo_surface_t *picture = picture_of(page);
    pixel_of(picture, 120, 90, rgb);
    cairo_surface_destroy(picture);
    tf_page_free(page);
}

START_TEST(the_nearer_sheet_is_on_top)
{
    int red_first[3], blue_first[3];
    middle_of_sheets(-1, 1, red_first);
    middle_of_sheets(1, -1, blue_first);
    ck_assert_int_gt(red_first[0], red_first[2] + 30);
    ck_assert_int_gt(blue_first[2], blue_first[0] + 30);
}
END_TEST

START_TEST(pictures_are_the_same_bytes_each_time)
{
    const char *const endings[] = {".png", ".pdf"};
    unsigned char *bytes[2];
    size_t size[2];
    for (int i = 0; i < 2; i++) {
        tf_page *page = full_page(&tf_theme_light);
        size[i] = write_page(page, endings[_i], &bytes[i]);
        tf_page_free(page);
    }
    ck_assert_uint_eq(size[0], size[1]);
    ck_assert_int_eq(memcmp(bytes[0], bytes[1], size[0]), 0);
    free(bytes[0]);
    free(bytes[1]);
}
END_TEST

START_TEST(pages_are_not_blank)
{
    const tf_theme *const themes[] = {&tf_theme_light, &tf_theme_dark};
    tf_page *page = full_page(themes[_i]);
    cairo_surface_t *picture = picture_of(page);
    int corner[3], other = 0;
    pixel_of(picture, 0, 0, corner);
    tf_rgb paper = themes[_i]->color[TF_ROLE_PAPER];
    ck_assert_int_eq(corner[0], (int)lround(255 * paper.r));
    for (int y = 0; y < 180; y++)
        for (int x = 0; x < 240; x++) {
            int rgb[3];
            pixel_of(picture, x, y, rgb);
            other += memcmp(rgb, corner, sizeof rgb) != 0;
        }
    ck_assert_int_gt(other, 240 * 180 / 20);
    ck_assert_int_lt(other, 240 * 180 * 9 / 10);
    cairo_surface_destroy(picture);
    tf_page_free(page);
}
END_TEST

START_TEST(solid_colours_are_those_of_the_theme)
{
    tf_page *page = new_page(&usual);
    const tf_rgb cell[2] = {{1, 0.5, 0}, {0, 0.5, 1}};
    tf_page_map(page, (tf_box){0, 0, 120, 90}, 2, 1, cell);
    tf_page_fill_box(page, (tf_box){0, 0, 120, 45},
                     (tf_paint){.role = TF_ROLE_EDGE});
    cairo_surface_t *picture = picture_of(page);
    int rgb[3];
    pixel_of(picture, 119, 170, rgb);
    ck_assert_int_eq(rgb[0], 255);
    pixel_of(picture, 120, 170, rgb);
    ck_assert_int_eq(rgb[2], 255);
    pixel_of(picture, 60, 40, rgb);
    ck_assert_int_eq(rgb[2],
                     (int)lround(255 * tf_theme_light.color[TF_ROLE_EDGE].b));
    cairo_surface_destroy(picture);
    tf_page_free(page);
}
END_TEST

START_TEST(labels_are_inside_and_disjoint)
{
    tf_page *page = full_page(&tf_theme_light);
    unsigned char *bytes;
    write_page(page, ".svg", &bytes);
    free(bytes);
    ck_assert_int_eq(tf_page_labels(page), 7);
    for (int i = 0; i < tf_page_labels(page); i++) {
        tf_placed own = tf_page_placed(page, i);
        ck_assert_double_gt(own.box.width * own.box.height, 0);
        ck_assert_double_ge(own.box.x, 0);
        ck_assert_double_ge(own.box.y, 0);
        ck_assert_double_le(own.box.x + own.box.width, 120);
        ck_assert_double_le(own.box.y + own.box.height, 90);
        for (int j = 0; j < i; j++) {
            tf_placed other = tf_page_placed(page, j);
            ck_assert_msg(tf_box_overlap(&own.box, &other.box) == 0,
                          "labels %d and %d", i, j);
        }
    }
    tf_page_free(page);
}
END_TEST

START_TEST(transparent_pages_have_no_paper)
{
    tf_page_options options = usual;
    options.transparent = true;
    tf_page *page = new_page(&options);
    tf_page_fill_box(page, (tf_box){0, 0, 60, 90},
                     (tf_paint){.role = TF_ROLE_EDGE});
    cairo_surface_t *picture = picture_of(page);
    const unsigned char *row = cairo_image_surface_get_data(picture);
    ck_assert_int_eq(row[4 * 200 + 3], 0);
    ck_assert_int_eq(row[4 * 20 + 3], 255);
    cairo_surface_destroy(picture);
    tf_page_free(page);
}
END_TEST

START_TEST(large_pictures_show_no_tiles)
{
    // One plain sheet over several tiles: all its pixels are alike.
    tf_page_options options = usual;
    options.pixels_x = 1200;
    options.pixels_y = 900;
    tf_page *page = new_page(&options);
    tf_panel *panel = tf_page_panel(page, (tf_box){0, 0, 120, 90});
    const double corner[3][3] = {{-90, 0, -90}, {90, 0, -90}, {0, 0, 90}};
    tf_scene_triangle(tf_panel_scene(panel), corner, 0,
                      (tf_paint){TF_ROLE_EDGE, 0.5, 0});
    tf_panel_look(panel, (tf_camera){.height = 9});
    cairo_surface_t *picture = picture_of(page);
    int first[3], rgb[3];
    pixel_of(picture, 0, 0, first);
    for (int y = 0; y < 900; y++)
        for (int x = 0; x < 1200; x++) {
            pixel_of(picture, x, y, rgb);
            ck_assert_msg(memcmp(rgb, first, sizeof rgb) == 0, "%d, %d", x, y);
        }
    cairo_surface_destroy(picture);
    tf_page_free(page);
}
END_TEST

START_TEST(png_records_its_resolution)
{
    tf_page *page = new_page(&usual);
    unsigned char *bytes;
    size_t size = write_page(page, ".png", &bytes);
    // 2 pixels a point are 144 dpi, 5669 pixels a meter.
    const unsigned char chunk[] = {'p', 'H', 'Y', 's',  0,  0, 0x16,
                                   37,  0,   0,   0x16, 37, 1};
    bool found = false;
    for (size_t i = 0; i + sizeof chunk <= size; i++)
        found = found || memcmp(bytes + i, chunk, sizeof chunk) == 0;
    ck_assert(found);
    free(bytes);
    tf_page_free(page);
}
END_TEST

START_TEST(kinds_of_files_begin_as_they_should)
{
    const char *const ending[] = {".png", ".pdf", ".svg"};
    const char *const begin[] = {"\x89PNG", "%PDF", "<?xml"};
    tf_page *page = full_page(&tf_theme_dark);
    for (int i = 0; i < 3; i++) {
        unsigned char *bytes;
        size_t size = write_page(page, ending[i], &bytes);
        ck_assert_uint_gt(size, 1000);
        ck_assert_int_eq(memcmp(bytes, begin[i], strlen(begin[i])), 0);
        free(bytes);
    }
    tf_page_free(page);
}
END_TEST

START_TEST(unwritable_files_are_told)
{
    tf_page *page = new_page(&usual);
    const char *const paths[] = {"/no/such/directory/a.png", "/proc/a.pdf",
                                 "/no/a.svg"};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(tf_page_write(page, paths[i]), TF_STAGE_UNWRITABLE);
        ck_assert_int_ne(errno, 0);
    }
    ck_assert_int_eq(tf_page_write(page, "a.gif"), TF_STAGE_UNKNOWN_KIND);
    ck_assert_int_eq(tf_page_write(page, ""), TF_STAGE_UNKNOWN_KIND);
    tf_page_free(page);
}
END_TEST

START_TEST(full_disks_are_told)
{
    const char *const ending[] = {".png", ".pdf", ".svg"};
    char path[256];
    name_file(path, ending[_i]);
    if (access("/dev/full", W_OK) != 0 || symlink("/dev/full", path) != 0)
        return;
    tf_page *page = full_page(&tf_theme_light);
    tf_stage_status status = tf_page_write(page, path);
    int error = errno;
    remove(path);
    ck_assert_int_eq(status, TF_STAGE_UNWRITABLE);
    ck_assert_int_eq(error, ENOSPC);
    tf_page_free(page);
}
END_TEST

START_TEST(sizes_out_of_range_are_refused)
{
    const int bad[] = {-1, 0, TF_PIXELS_LEAST - 1, TF_PIXELS_MOST + 1};
    for (int i = 0; i < 8; i++) {
        tf_page_options options = usual;
        *(i % 2 ? &options.pixels_x : &options.pixels_y) = bad[i / 2];
        tf_page *page;
        ck_assert_int_eq(tf_page_new(&options, &page), TF_STAGE_BAD_SIZE);
        ck_assert_ptr_null(page);
    }
}
END_TEST

START_TEST(missing_fonts_are_refused)
{
    tf_page_options options = usual;
    options.family = "No Such Family";
    tf_page *page;
    ck_assert_int_eq(tf_page_new(&options, &page), TF_STAGE_NO_FONT);
    ck_assert_ptr_null(page);
}
END_TEST

START_TEST(bad_labels_are_told_when_written)
{
    tf_page *page = new_page(&usual);
    tf_page_label(page, 10, 10, (tf_label){.text = "$x"});
    char path[256];
    name_file(path, ".png");
    ck_assert_int_eq(tf_page_write(page, path), TF_STAGE_BAD_TEXT);
    remove(path);
    tf_page_free(page);
}
END_TEST

START_TEST(turned_pages_turn_what_is_not_fixed)
{
    tf_page_options options = usual;
    options.turned = true;
    options.azimuth = 90;
    tf_page *page = new_page(&options);
    double at[2][2];
    for (int i = 0; i < 2; i++) {
        tf_panel *panel = tf_page_panel(page, (tf_box){0, 0, 120, 90});
        tf_panel_look(panel, (tf_camera){.height = 9});
        if (i == 1)
            tf_panel_fix(panel);
        tf_panel_project(panel, (double[]){1, 2, 0}, at[i]);
    }
    ck_assert_double_eq_tol(at[0][0], 80, 1e-9);
    ck_assert_double_eq_tol(at[1][0], 70, 1e-9);
    tf_page_free(page);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("stage/page");
    TCase *tests = tcase_create("page");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, the_nearer_sheet_is_on_top);
    tcase_add_loop_test(tests, pictures_are_the_same_bytes_each_time, 0, 2);
    tcase_add_loop_test(tests, pages_are_not_blank, 0, 2);
    tcase_add_test(tests, solid_colours_are_those_of_the_theme);
    tcase_add_test(tests, labels_are_inside_and_disjoint);
    tcase_add_test(tests, transparent_pages_have_no_paper);
    tcase_add_test(tests, large_pictures_show_no_tiles);
    tcase_add_test(tests, png_records_its_resolution);
    tcase_add_test(tests, kinds_of_files_begin_as_they_should);
    tcase_add_test(tests, unwritable_files_are_told);
    tcase_add_loop_test(tests, full_disks_are_told, 0, 3);
    tcase_add_test(tests, sizes_out_of_range_are_refused);
    tcase_add_test(tests, missing_fonts_are_refused);
    tcase_add_test(tests, bad_labels_are_told_when_written);
    tcase_add_test(tests, turned_pages_turn_what_is_not_fixed);
    return made;
}
