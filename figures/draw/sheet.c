#define _GNU_SOURCE // open_memstream
#include "draw/sheet.h"

#include "renderer/list.h"

#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 32, ///< of a tile, pixels
    COLUMNS = 32,
    BUCKETS = 1 << 14,
    NONE = -1
};

/// The pixels of a tile, row by row; those beyond the frame are black.
typedef struct tile {
    uint32_t pixel[SIDE * SIDE];
} tile;

struct fig_sheet {
    int width, height; ///< of a frame, pixels
    int frames;
    tile *tiles;
    int *next; ///< the tile before in the same bucket, or NONE
    int tile_count, tile_room, next_room;
    int bucket[BUCKETS]; ///< the last tile in each, or NONE
    int *shown;          ///< the tiles of the last frame
    FILE *runs;          ///< what the text chunk has of the frames
    char *text;
    size_t length;
};

// The sheet --------------------------------------------------------------

static int tiles_across(const fig_sheet *sheet)
{
    return (sheet->width + SIDE - 1) / SIDE;
}

static int tiles_of_frame(const fig_sheet *sheet)
{
    return tiles_across(sheet) * ((sheet->height + SIDE - 1) / SIDE);
}

fig_sheet *fig_sheet_new(int width, int height)
{
    fig_sheet *sheet = calloc(1, sizeof *sheet);
    if (!sheet)
        return NULL;
    sheet->width = width;
    sheet->height = height;
    for (int i = 0; i < BUCKETS; i++)
        sheet->bucket[i] = NONE;
    sheet->shown = malloc((size_t)tiles_of_frame(sheet) * sizeof(int));
    sheet->runs = open_memstream(&sheet->text, &sheet->length);
    for (int i = 0; i < tiles_of_frame(sheet) && sheet->shown; i++)
        sheet->shown[i] = NONE;
    if (sheet->shown && sheet->runs)
        return sheet;
    fig_sheet_free(sheet);
    return NULL;
}

void fig_sheet_free(fig_sheet *sheet)
{
    if (!sheet)
        return;
    if (sheet->runs)
        fclose(sheet->runs);
    free(sheet->text);
    free(sheet->tiles);
    free(sheet->next);
    free(sheet->shown);
    free(sheet);
}

// Tiles ------------------------------------------------------------------

/// By FNV-1a, of pixels instead of bytes.
static int bucket_of(const tile *t)
{
    uint64_t hash = 0xcbf29ce484222325;
    for (int i = 0; i < SIDE * SIDE; i++)
        hash = (hash ^ t->pixel[i]) * 0x100000001b3;
    return (int)((hash ^ hash >> 32) % BUCKETS);
}

/// The index of a tile, which is added if it is new.  NONE without memory.
static int find_tile(fig_sheet *sheet, const tile *t)
{
    int bucket = bucket_of(t), last = sheet->bucket[bucket];
    for (int i = last; i != NONE; i = sheet->next[i])
        if (memcmp(&sheet->tiles[i], t, sizeof *t) == 0)
            return i;
    if (!fig_list_room(&sheet->tiles, sheet->tile_count, 1, &sheet->tile_room,
                       sizeof *sheet->tiles) ||
        !fig_list_room(&sheet->next, sheet->tile_count, 1, &sheet->next_room,
                       sizeof *sheet->next))
        return NONE;
    sheet->tiles[sheet->tile_count] = *t;
    sheet->next[sheet->tile_count] = last;
    return sheet->bucket[bucket] = sheet->tile_count++;
}

/// A color of seven bits a channel, which the eye does not tell from the given
/// one; white and black stay.
static uint32_t coarse(uint32_t pixel)
{
    return (pixel & 0xfefefe) | (pixel >> 7 & 0x010101);
}

/// The tile at a place of a frame, counted row by row.
static tile cut_tile(const fig_sheet *sheet, const uint32_t pixels[], int place)
{
    int left = place % tiles_across(sheet) * SIDE;
    int top = place / tiles_across(sheet) * SIDE;
    tile t = {{0}};
    for (int y = 0; y < SIDE && top + y < sheet->height; y++)
        for (int x = 0; x < SIDE && left + x < sheet->width; x++)
            t.pixel[SIDE * y + x] =
                coarse(pixels[sheet->width * (top + y) + left + x]);
    return t;
}

// Frames -----------------------------------------------------------------

static void put_number(FILE *stream, int number)
{
    if (number >= 36)
        put_number(stream, number / 36);
    fputc("0123456789abcdefghijklmnopqrstuvwxyz"[number % 36], stream);
}

/// Write down which tiles changed from the last frame to the one that has
/// `tiles`.
static void put_runs(const fig_sheet *sheet, const int tiles[])
{
    int places = tiles_of_frame(sheet), end = 0;
    for (int i = 0; i < places; i++) {
        if (tiles[i] == sheet->shown[i])
            continue;
        int first = i;
        while (i + 1 < places && tiles[i + 1] == tiles[i] + 1 &&
               tiles[i + 1] != sheet->shown[i + 1])
            i++;
        fputs(end > 0 ? " " : "", sheet->runs);
        put_number(sheet->runs, first - end);
        fputc(',', sheet->runs);
        put_number(sheet->runs, i + 1 - first);
        fputc(',', sheet->runs);
        put_number(sheet->runs, tiles[first]);
        end = i + 1;
    }
    fputc('\n', sheet->runs);
}

bool fig_sheet_add(fig_sheet *sheet, const uint32_t pixels[])
{
    int places = tiles_of_frame(sheet);
    int *tiles = malloc((size_t)places * sizeof *tiles);
    bool added = tiles != NULL;
    for (int i = 0; i < places && added; i++) {
        tile t = cut_tile(sheet, pixels, i);
        added = (tiles[i] = find_tile(sheet, &t)) != NONE;
    }
    if (added) {
        put_runs(sheet, tiles);
        memcpy(sheet->shown, tiles, (size_t)places * sizeof *tiles);
        sheet->frames++;
    }
    free(tiles);
    return added;
}

// The file ---------------------------------------------------------------

static void fail(png_structp png, png_const_charp message)
{
    (void)message;
    png_longjmp(png, 1);
}

static void ignore(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

/// A row of pixels of the sheet: of red, green, blue.
static void fill_row(const fig_sheet *sheet, int y, png_bytep row)
{
    memset(row, 0, 3 * (size_t)(COLUMNS * SIDE));
    for (int x = 0; x < COLUMNS * SIDE; x++) {
        int i = y / SIDE * COLUMNS + x / SIDE;
        if (i >= sheet->tile_count)
            return;
        uint32_t pixel = sheet->tiles[i].pixel[y % SIDE * SIDE + x % SIDE];
        for (int k = 0; k < 3; k++)
            row[3 * x + k] = (png_byte)(pixel >> (16 - 8 * k) & 255);
    }
}

static void put_text(const fig_sheet *sheet, png_structp png, png_infop info)
{
    char key[] = "film", *text;
    fflush(sheet->runs);
    if (asprintf(&text, "%d %d %d %d %d\n%s", sheet->width, sheet->height, SIDE,
                 COLUMNS, sheet->frames, sheet->text) < 0)
        png_error(png, "memory");
    png_text chunk = {
        .compression = PNG_TEXT_COMPRESSION_NONE, .key = key, .text = text};
    png_set_text(png, info, &chunk, 1);
    free(text);
}

static void put_sheet(const fig_sheet *sheet, png_structp png, png_infop info,
                      png_bytep row)
{
    int rows = (sheet->tile_count + COLUMNS - 1) / COLUMNS * SIDE;
    png_set_IHDR(png, info, COLUMNS * SIDE, (png_uint_32)rows, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 9);
    png_set_filter(png, 0, PNG_FILTER_NONE);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    put_text(sheet, png, info);
    png_write_info(png, info);
    for (int y = 0; y < rows; y++) {
        fill_row(sheet, y, row);
        png_write_row(png, row);
    }
    png_write_end(png, info);
}

static bool write_to(const fig_sheet *sheet, FILE *stream)
{
    png_bytep row = malloc(3 * (size_t)(COLUMNS * SIDE));
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, fail, ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    volatile bool written = false;
    if (row && info && setjmp(png_jmpbuf(png)) == 0) {
        png_init_io(png, stream);
        put_sheet(sheet, png, info, row);
        written = true;
    }
    png_destroy_write_struct(&png, &info);
    free(row);
    return written;
}

bool fig_sheet_write(const fig_sheet *sheet, const char *path)
{
    FILE *stream = fopen(path, "wb");
    bool written = stream && write_to(sheet, stream);
    return stream && fclose(stream) == 0 && written;
}
