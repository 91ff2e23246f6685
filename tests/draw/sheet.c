#define _POSIX_C_SOURCE 200809L // strdup

#include "draw/sheet.h"

#include "support/picture_folder.h"
#include "support/support.h"

#include <cairo.h>
#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 75, ///< of a frame, not a multiple of a tile's side
    HEIGHT = 40,
    FRAMES = 5
};

/// The color of a pixel of the i-th frame: a square moves over a pattern, and
/// the last frame is the first one.
static unsigned color_at(int i, int x, int y)
{
    int left = 20 * (i % (FRAMES - 1));
    bool inside = x >= left && x < left + 6 && y >= 30 && y < 36;
    return inside ? 0xc81e00 : (unsigned)(x * 3 << 16 | y * 5 << 8 | 17);
}

/// The same as the sheet keeps it, in seven bits a channel.
static unsigned kept_at(int i, int x, int y)
{
    unsigned color = color_at(i, x, y), kept = 0;
    for (int k = 0; k < 24; k += 8) {
        unsigned channel = color >> k & 255;
        kept |= (channel / 2 * 2 + channel / 128) << k;
    }
    return kept;
}

static void fill_frame(int i, uint32_t pixels[WIDTH * HEIGHT])
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            pixels[WIDTH * y + x] = 0xff000000 | color_at(i, x, y);
}

static void write_sheet(void)
{
    uint32_t pixels[WIDTH * HEIGHT];
    fig_sheet *sheet = fig_sheet_new(WIDTH, HEIGHT);
    ck_assert_ptr_nonnull(sheet);
    for (int i = 0; i < FRAMES; i++) {
        fill_frame(i, pixels);
        ck_assert(fig_sheet_add(sheet, pixels));
    }
    ck_assert(fig_sheet_write(sheet, picture_path()));
    fig_sheet_free(sheet);
}

/// The text chunk of the sheet.  The caller frees it.
static char *read_text(void)
{
    FILE *file = fopen(picture_path(), "rb");
    ck_assert_ptr_nonnull(file);
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_info(png, info);
    png_textp chunk;
    int count;
    png_get_text(png, info, &chunk, &count);
    ck_assert_int_eq(count, 1);
    ck_assert_str_eq(chunk->key, "film");
    char *text = strdup(chunk->text);
    png_destroy_read_struct(&png, &info, NULL);
    fclose(file);
    return text;
}

/// Read the runs of a frame into the tiles of the one before; returns the rest.
static char *read_runs(char *text, int places, int tiles[])
{
    for (int place = 0; *text != '\n';) {
        place += (int)strtol(text, &text, 36);
        int count = (int)strtol(text + 1, &text, 36);
        int first = (int)strtol(text + 1, &text, 36);
        ck_assert_int_le(place + count, places);
        for (int i = 0; i < count; i++)
            tiles[place++] = first + i;
        text += *text == ' ';
    }
    return text + 1;
}

static unsigned pixel_of(cairo_surface_t *surface, int x, int y)
{
    unsigned pixel;
    memcpy(&pixel,
           cairo_image_surface_get_data(surface) +
               (ptrdiff_t)cairo_image_surface_get_stride(surface) * y +
               (ptrdiff_t)4 * x,
           4);
    return pixel & 0xffffff;
}

START_TEST(frames_are_read_back_the_same)
{
    write_sheet();
    char *text = read_text(), *at = text;
    int width, height, side, columns, frames, tiles[64] = {0};
    ck_assert_int_eq(sscanf(text, "%d %d %d %d %d", &width, &height, &side,
                            &columns, &frames),
                     5);
    ck_assert_int_eq(width, WIDTH);
    ck_assert_int_eq(height, HEIGHT);
    ck_assert_int_eq(frames, FRAMES);
    int across = (width + side - 1) / side;
    int places = across * ((height + side - 1) / side);
    cairo_surface_t *sheet =
        cairo_image_surface_create_from_png(picture_path());
    at = strchr(at, '\n') + 1;
    for (int i = 0; i < FRAMES; i++) {
        at = read_runs(at, places, tiles);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                int tile = tiles[y / side * across + x / side];
                unsigned found =
                    pixel_of(sheet, tile % columns * side + x % side,
                             tile / columns * side + y % side);
                ck_assert_msg(found == kept_at(i, x, y),
                              "frame %d, (%d, %d): %06x, not %06x", i, x, y,
                              found, kept_at(i, x, y));
            }
    }
    ck_assert_int_eq(*at, '\0');
    cairo_surface_destroy(sheet);
    free(text);
}
END_TEST

/// The pattern has six tiles.  The square is in two of them at three times and
/// in four at one; at the last time there is nothing new.
START_TEST(a_tile_is_kept_once)
{
    write_sheet();
    char *text = read_text();
    int most = 0;
    for (char *at = strchr(text, '\n') + 1; *at;) {
        int tiles[64] = {0};
        at = read_runs(at, 6, tiles);
        for (int i = 0; i < 6; i++)
            most = tiles[i] > most ? tiles[i] : most;
    }
    ck_assert_int_eq(most + 1, 6 + 3 * 2 + 4);
    free(text);
}
END_TEST

START_TEST(a_missing_folder_is_reported)
{
    fig_sheet *sheet = fig_sheet_new(WIDTH, HEIGHT);
    ck_assert(!fig_sheet_write(sheet, "/tmp/no-such-folder/a.png"));
    ck_assert_int_eq(errno, ENOENT);
    fig_sheet_free(sheet);
    fig_sheet_free(NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("draw/sheet");
    TCase *sheets = tcase_create("sheets");
    tcase_add_checked_fixture(sheets, make_picture_folder,
                              remove_picture_folder);
    tcase_add_test(sheets, frames_are_read_back_the_same);
    tcase_add_test(sheets, a_tile_is_kept_once);
    tcase_add_test(sheets, a_missing_folder_is_reported);
    suite_add_tcase(s, sheets);
    return s;
}
