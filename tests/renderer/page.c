#define _XOPEN_SOURCE 600 // setrlimit

#include "renderer/page.h"

#include "renderer/box.h"
#include "support/support.h"

#include <cairo.h>
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static const fig_page_options usual = {
    .width = 120, .height = 90, .pixels_x = 240, .pixels_y = 180};

static fig_page *new_page(const fig_page_options *options)
{
    fig_page *page;
    ck_assert_int_eq(fig_page_new(options, &page), FIG_OK);
    return page;
}

/// A name of its own in the directory for such files.
static void name_file(char path[256], const char *ending)
{
    const char *directory = getenv("TMPDIR");
    snprintf(path, 256, "%s/tanglefree-renderer-%ld%s",
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

static size_t write_page(fig_page *page, const char *ending,
                         unsigned char **bytes)
{
    char path[256];
    name_file(path, ending);
    ck_assert_int_eq(fig_page_write(page, path), FIG_OK);
    return take_file(path, bytes);
}

/// The page as pixels, read back from a PNG file.
static cairo_surface_t *picture_of(fig_page *page)
{
    char path[256];
    name_file(path, ".png");
    ck_assert_int_eq(fig_page_write(page, path), FIG_OK);
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
static fig_page *full_page(const fig_theme *theme)
{
    fig_page_options options = usual;
    options.theme = theme;
    fig_page *page = new_page(&options);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 80});
    fig_scene *scene = fig_panel_scene(panel);
    const tf_vector corner[4] = {
        {{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    const char *const axis[3] = {"$x$", "$y$", "$t$"};
    fig_scene_tetrahedron(scene, corner, FIG_WIDTH_THIN,
                          (fig_paint){FIG_ROLE_TRIANGLE, 0.4, 0});
    fig_scene_ball(scene, corner[3], FIG_WIDTH_BALL,
                   (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_worldline(scene, corner[1], corner[3], FIG_WIDTH_TUBE,
                        (fig_paint){.role = FIG_ROLE_POINT});
    fig_scene_dashes(scene, corner[2], corner[3], FIG_WIDTH_LINE, 3,
                     (fig_paint){.role = FIG_ROLE_EDGE});
    fig_scene_grid(scene, corner[0], corner[1], corner[2], 4, 4,
                   FIG_ROLE_START);
    fig_panel_axes(panel, (tf_vector){{-0.2, -0.2, 0}},
                   (tf_vector){{1, 1, 1.4}}, axis);
    fig_panel_look(panel,
                   (fig_camera){.azimuth = 25, .elevation = 20, .distance = 8});
    for (int i = 0; i < 4; i++)
        fig_panel_label(panel, corner[i], (fig_label){.text = "$\\bar{p}_0$"});
    fig_page_text(page, 60, 88, FIG_ALIGN_CENTER, "a caption",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    return page;
}

/// A red sheet and a blue one, each half the page high and more, that cross
/// in depth when seen from the front: y is how far behind a sheet is.
static void middle_of_sheets(double red_y, double blue_y, int rgb[3])
{
    fig_page *page = new_page(&usual);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
    const double y[2] = {red_y, blue_y};
    const fig_role role[2] = {FIG_ROLE_CONTACT, FIG_ROLE_EDGE};
    for (int i = 0; i < 2; i++) {
        const tf_vector corner[3] = {
            {{-9, y[i], -9}}, {{9, y[i], -9}}, {{0, y[i], 9}}};
        fig_scene_triangle(fig_panel_scene(panel), corner, 0,
                           (fig_paint){role[i], 0.7, 0});
    }
    fig_panel_look(panel, (fig_camera){.height = 9});
    cairo_surface_t *picture = picture_of(page);
    pixel_of(picture, 120, 90, rgb);
    cairo_surface_destroy(picture);
    fig_page_free(page);
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
        fig_page *page = full_page(&fig_theme_light);
        size[i] = write_page(page, endings[_i], &bytes[i]);
        fig_page_free(page);
    }
    ck_assert_uint_eq(size[0], size[1]);
    ck_assert_int_eq(memcmp(bytes[0], bytes[1], size[0]), 0);
    free(bytes[0]);
    free(bytes[1]);
}
END_TEST

START_TEST(pages_are_not_blank)
{
    const fig_theme *const themes[] = {&fig_theme_light, &fig_theme_dark};
    fig_page *page = full_page(themes[_i]);
    cairo_surface_t *picture = picture_of(page);
    int corner[3], other = 0;
    pixel_of(picture, 0, 0, corner);
    fig_rgb paper = themes[_i]->color[FIG_ROLE_PAPER];
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
    fig_page_free(page);
}
END_TEST

START_TEST(solid_colors_are_those_of_the_theme)
{
    fig_page *page = new_page(&usual);
    const fig_rgb cell[2] = {{1, 0.5, 0}, {0, 0.5, 1}};
    fig_page_map(page, (fig_box){0, 0, 120, 90}, 2, 1, cell);
    fig_page_fill_box(page, (fig_box){0, 0, 120, 45},
                      (fig_paint){.role = FIG_ROLE_EDGE});
    cairo_surface_t *picture = picture_of(page);
    int rgb[3];
    pixel_of(picture, 119, 170, rgb);
    ck_assert_int_eq(rgb[0], 255);
    pixel_of(picture, 120, 170, rgb);
    ck_assert_int_eq(rgb[2], 255);
    pixel_of(picture, 60, 40, rgb);
    ck_assert_int_eq(rgb[2],
                     (int)lround(255 * fig_theme_light.color[FIG_ROLE_EDGE].b));
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

START_TEST(labels_are_inside_and_disjoint)
{
    fig_page *page = full_page(&fig_theme_light);
    unsigned char *bytes;
    write_page(page, ".svg", &bytes);
    free(bytes);
    ck_assert_int_eq(fig_page_labels(page), 7);
    for (int i = 0; i < fig_page_labels(page); i++) {
        fig_placed own = fig_page_placed(page, i);
        ck_assert_double_gt(own.box.width * own.box.height, 0);
        ck_assert_double_ge(own.box.x, 0);
        ck_assert_double_ge(own.box.y, 0);
        ck_assert_double_le(own.box.x + own.box.width, 120);
        ck_assert_double_le(own.box.y + own.box.height, 90);
        for (int j = 0; j < i; j++) {
            fig_placed other = fig_page_placed(page, j);
            ck_assert_msg(fig_box_overlap(&own.box, &other.box) == 0,
                          "labels %d and %d", i, j);
        }
    }
    fig_page_free(page);
}
END_TEST

START_TEST(transparent_pages_have_no_paper)
{
    fig_page_options options = usual;
    options.transparent = true;
    fig_page *page = new_page(&options);
    fig_page_fill_box(page, (fig_box){0, 0, 60, 90},
                      (fig_paint){.role = FIG_ROLE_EDGE});
    cairo_surface_t *picture = picture_of(page);
    const unsigned char *row = cairo_image_surface_get_data(picture);
    ck_assert_int_eq(row[4 * 200 + 3], 0);
    ck_assert_int_eq(row[4 * 20 + 3], 255);
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

START_TEST(large_pictures_show_no_tiles)
{
    // One plain sheet over several tiles: all its pixels are alike.
    fig_page_options options = usual;
    options.pixels_x = 1200;
    options.pixels_y = 900;
    fig_page *page = new_page(&options);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
    const tf_vector corner[3] = {{{-90, 0, -90}}, {{90, 0, -90}}, {{0, 0, 90}}};
    fig_scene_triangle(fig_panel_scene(panel), corner, 0,
                       (fig_paint){FIG_ROLE_EDGE, 0.5, 0});
    fig_panel_look(panel, (fig_camera){.height = 9});
    cairo_surface_t *picture = picture_of(page);
    int first[3], rgb[3];
    pixel_of(picture, 0, 0, first);
    for (int y = 0; y < 900; y++)
        for (int x = 0; x < 1200; x++) {
            pixel_of(picture, x, y, rgb);
            ck_assert_msg(memcmp(rgb, first, sizeof rgb) == 0, "%d, %d", x, y);
        }
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

/// A sheet of small facets, seen from the front, from -`half` to `half`.
static void add_facets(fig_scene *scene, float half)
{
    enum {
        CELLS = 60
    };
    fig_facet *facet = fig_scene_facets(scene, 2 * CELLS * CELLS);
    ck_assert_ptr_nonnull(facet);
    for (int i = 0; i < 2 * CELLS * CELLS; i++) {
        int row = i / 2 / CELLS, column = i / 2 % CELLS, up = i % 2;
        const int corner[3][2] = {{up, up}, {1, 0}, {0, 1}};
        facet[i] = (fig_facet){.role = FIG_ROLE_EDGE};
        for (int c = 0; c < 3; c++) {
            int x = column + corner[c][0], z = row + corner[c][1];
            facet[i].at[c][0] = half * (2 * (float)x / CELLS - 1);
            facet[i].at[c][2] = half * (2 * (float)z / CELLS - 1);
            facet[i].normal[c][1] = i % 7 % 2 ? 1 : -1;
        }
    }
}

/// However near the eye: some facets are beside it and behind it.
START_TEST(large_pictures_miss_no_facets)
{
    static const double distance[] = {0, 20, 3};
    fig_page_options options = usual;
    options.pixels_x = 1200;
    options.pixels_y = 900;
    fig_page *page = new_page(&options);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
    add_facets(fig_panel_scene(panel), 30);
    fig_panel_look(panel, (fig_camera){.height = 9,
                                       .elevation = _i == 2 ? 20 : 0,
                                       .distance = distance[_i]});
    cairo_surface_t *picture = picture_of(page);
    int rgb[3], paper = 0;
    for (int y = 0; y < 900; y++)
        for (int x = 0; x < 1200; x++) {
            pixel_of(picture, x, y, rgb);
            paper += rgb[0] > 200;
        }
    ck_assert_int_eq(paper, 0);
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

/// From before the eye up to behind it, where the way back seems to go down.
START_TEST(triangles_beyond_the_eye_are_seen)
{
    fig_page_options options = usual;
    options.pixels_x = 1200;
    options.pixels_y = 900;
    fig_page *page = new_page(&options);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
    fig_scene *scene = fig_panel_scene(panel);
    const fig_paint paint = {.role = FIG_ROLE_EDGE};
    const tf_vector corner[3] = {{{-4, 10, -1}}, {{4, 10, -1}}, {{0, -6, 0.1}}};
    const tf_vector below[3] = {{{5, 0, -4}}, {{5.2, 0, -4}}, {{5, 0, -4.2}}};
    fig_scene_triangle(scene, corner, 0, paint);
    fig_scene_triangle(scene, below, 0, paint);
    fig_panel_look(panel, (fig_camera){.height = 9, .distance = 3});
    cairo_surface_t *picture = picture_of(page);
    int rgb[3];
    pixel_of(picture, 600, 750, rgb);
    ck_assert_int_lt(rgb[0], 200);
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

/// A camera is not fitted to facets, and a scene with them alone is drawn.
START_TEST(facets_are_lit_from_both_sides)
{
    fig_page *page = new_page(&usual);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
    add_facets(fig_panel_scene(panel), 1);
    fig_panel_look(panel, (fig_camera){.height = 3});
    cairo_surface_t *picture = picture_of(page);
    int first[3], rgb[3];
    pixel_of(picture, 120, 90, first);
    ck_assert_int_gt(first[2], first[0] + 50);
    for (int y = 40; y < 140; y++) {
        pixel_of(picture, 110, y, rgb);
        for (int k = 0; k < 3; k++)
            ck_assert_int_le(abs(rgb[k] - first[k]), 12);
    }
    pixel_of(picture, 5, 90, rgb);
    ck_assert_int_eq(rgb[0], 255);
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

/// A painted triangle has its colors, whatever way it faces, near or far.
START_TEST(painted_triangles_are_not_lit)
{
    fig_page *page = new_page(&usual);
    fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
    fig_painted *painted = fig_scene_painted(fig_panel_scene(panel), 2);
    const fig_rgb color = {0.2, 0.5, 0.8};
    for (int i = 0; i < 2; i++)
        for (int c = 0; c < 3; c++) {
            const float at[3] = {c == 1 ? 9 : 0, i == 1 ? 40 : (float)c,
                                 c == 2 ? 9 : 0};
            const float linear[3] = {(float)fig_rgb_to_linear(color.r),
                                     (float)fig_rgb_to_linear(color.g),
                                     (float)fig_rgb_to_linear(color.b)};
            memcpy(painted[i].color[c], linear, sizeof linear);
            for (int k = 0; k < 3; k++)
                painted[i].at[c][k] = i == 1 && k != 1 ? -at[k] : at[k];
        }
    fig_panel_look(panel, (fig_camera){.height = 4});
    cairo_surface_t *picture = picture_of(page);
    for (int i = 0; i < 2; i++) {
        int rgb[3];
        pixel_of(picture, 120 + (i == 0 ? 30 : -30), i == 0 ? 60 : 120, rgb);
        ck_assert_int_le(abs(rgb[0] - 51), 1);
        ck_assert_int_le(abs(rgb[1] - 128), 1);
        ck_assert_int_le(abs(rgb[2] - 204), 1);
    }
    cairo_surface_destroy(picture);
    fig_page_free(page);
}
END_TEST

START_TEST(png_records_its_resolution)
{
    fig_page *page = new_page(&usual);
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
    fig_page_free(page);
}
END_TEST

START_TEST(files_begin_with_the_signature_of_their_kind)
{
    const char *const ending[] = {".png", ".pdf", ".svg"};
    const char *const begin[] = {"\x89PNG", "%PDF", "<?xml"};
    fig_page *page = full_page(&fig_theme_dark);
    for (int i = 0; i < 3; i++) {
        unsigned char *bytes;
        size_t size = write_page(page, ending[i], &bytes);
        ck_assert_uint_gt(size, 1000);
        ck_assert_int_eq(memcmp(bytes, begin[i], strlen(begin[i])), 0);
        free(bytes);
    }
    fig_page_free(page);
}
END_TEST

START_TEST(unwritable_files_are_reported)
{
    fig_page *page = new_page(&usual);
    const char *const paths[] = {"/no/such/directory/a.png", "/proc/a.pdf",
                                 "/no/a.svg"};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(fig_page_write(page, paths[i]), FIG_UNWRITABLE);
        ck_assert_int_ne(errno, 0);
    }
    ck_assert_int_eq(fig_page_write(page, "a.gif"), FIG_UNKNOWN_KIND);
    ck_assert_int_eq(fig_page_write(page, ""), FIG_UNKNOWN_KIND);
    fig_page_free(page);
}
END_TEST

/// Let no file of the process grow beyond `bytes`, as on a full disk.  Returns
/// the limit before.
static rlim_t limit_files(rlim_t bytes)
{
    struct rlimit limit;
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &limit), 0);
    rlim_t before = limit.rlim_cur;
    limit.rlim_cur = bytes;
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    return before;
}

/// A large file fails as it is written, a small one when it is closed.
START_TEST(full_disks_are_reported)
{
    const char *const ending[] = {".png", ".pdf", ".svg"};
    char path[256];
    name_file(path, ending[_i / 2]);
    signal(SIGXFSZ, SIG_IGN);
    fig_page *page =
        _i % 2 == 0 ? full_page(&fig_theme_light) : new_page(&usual);
    rlim_t before = limit_files(100);
    fig_status status = fig_page_write(page, path);
    int error = errno;
    limit_files(before);
    remove(path);
    ck_assert_int_eq(status, FIG_UNWRITABLE);
    ck_assert_int_eq(error, EFBIG);
    fig_page_free(page);
}
END_TEST

START_TEST(sizes_out_of_range_are_refused)
{
    const int bad[] = {-1, 0, FIG_PIXELS_LEAST - 1, FIG_PIXELS_MOST + 1};
    for (int i = 0; i < 8; i++) {
        fig_page_options options = usual;
        *(i % 2 ? &options.pixels_x : &options.pixels_y) = bad[i / 2];
        fig_page *page;
        ck_assert_int_eq(fig_page_new(&options, &page), FIG_BAD_SIZE);
        ck_assert_ptr_null(page);
    }
}
END_TEST

START_TEST(missing_fonts_are_refused)
{
    fig_page_options options = usual;
    options.family = "No Such Family";
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_NO_FONT);
    ck_assert_ptr_null(page);
}
END_TEST

START_TEST(bad_labels_are_reported_when_written)
{
    fig_page *page = new_page(&usual);
    fig_page_label(page, 10, 10, (fig_label){.text = "$x"});
    char path[256];
    name_file(path, ".png");
    ck_assert_int_eq(fig_page_write(page, path), FIG_BAD_TEXT);
    remove(path);
    fig_page_free(page);
}
END_TEST

START_TEST(turning_a_page_turns_all_that_is_not_fixed)
{
    fig_page_options options = usual;
    options.turned = true;
    options.azimuth = 90;
    fig_page *page = new_page(&options);
    fig_point at[2];
    for (int i = 0; i < 2; i++) {
        fig_panel *panel = fig_page_panel(page, (fig_box){0, 0, 120, 90});
        fig_panel_look(panel, (fig_camera){.height = 9});
        if (i == 1)
            fig_panel_fix(panel);
        at[i] = fig_panel_project(panel, (tf_vector){{1, 2, 0}});
    }
    ck_assert_double_eq_tol(at[0].x, 80, 1e-9);
    ck_assert_double_eq_tol(at[1].x, 70, 1e-9);
    fig_page_free(page);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/page");
    TCase *tests = tcase_create("page");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, the_nearer_sheet_is_on_top);
    tcase_add_loop_test(tests, pictures_are_the_same_bytes_each_time, 0, 2);
    tcase_add_loop_test(tests, pages_are_not_blank, 0, 2);
    tcase_add_test(tests, solid_colors_are_those_of_the_theme);
    tcase_add_test(tests, labels_are_inside_and_disjoint);
    tcase_add_test(tests, transparent_pages_have_no_paper);
    tcase_add_test(tests, large_pictures_show_no_tiles);
    tcase_add_loop_test(tests, large_pictures_miss_no_facets, 0, 3);
    tcase_add_test(tests, triangles_beyond_the_eye_are_seen);
    tcase_add_test(tests, facets_are_lit_from_both_sides);
    tcase_add_test(tests, painted_triangles_are_not_lit);
    tcase_add_test(tests, png_records_its_resolution);
    tcase_add_test(tests, files_begin_with_the_signature_of_their_kind);
    tcase_add_test(tests, unwritable_files_are_reported);
    tcase_add_loop_test(tests, full_disks_are_reported, 0, 6);
    tcase_add_test(tests, sizes_out_of_range_are_refused);
    tcase_add_test(tests, missing_fonts_are_refused);
    tcase_add_test(tests, bad_labels_are_reported_when_written);
    tcase_add_test(tests, turning_a_page_turns_all_that_is_not_fixed);
    return made;
}
