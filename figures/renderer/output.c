#include "renderer/page_parts.h"
#include "renderer/picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <errno.h>
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The page, drawn --------------------------------------------------------

/// The resolution to which cairo's vector surfaces turn what they cannot keep
/// as vectors.
static const double fallback_dpi = 300;

static fig_status draw_panel(fig_renderer **renderer, const fig_panel *panel,
                             fig_raster raster, cairo_t *cairo)
{
    fig_status status = FIG_OK;
    if (*renderer == NULL)
        status = fig_renderer_new(renderer);
    fig_picture picture = {.surface = NULL};
    if (status == FIG_OK)
        status = fig_picture_draw(*renderer, panel, raster, &picture);
    if (picture.surface == NULL)
        return status;
    cairo_save(cairo);
    cairo_scale(cairo, 1 / raster.scale, 1 / raster.scale);
    cairo_set_source_surface(cairo, picture.surface, picture.x - raster.shift_x,
                             picture.y - raster.shift_y);
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(picture.surface);
    return status;
}

/// Let no line of another part reach into the one that is shown.
static void clip(const fig_page *page, cairo_t *cairo)
{
    const fig_box *box = &page->content;
    if (!page->cropped)
        return;
    cairo_rectangle(cairo, box->x, box->y, box->width, box->height);
    cairo_clip(cairo);
}

/// Draw all; `cairo` counts in points.
static fig_status draw_page(fig_page *page, cairo_t *cairo)
{
    const fig_theme *theme = page->options.theme;
    fig_rgb paper = theme->color[FIG_ROLE_PAPER];
    if (!page->options.transparent) {
        cairo_set_source_rgb(cairo, paper.r, paper.g, paper.b);
        cairo_paint(cairo);
    }
    fig_renderer *own = NULL;
    fig_renderer **renderer =
        page->options.renderer != NULL ? page->options.renderer : &own;
    fig_status status = page->trouble;
    cairo_save(cairo);
    clip(page, cairo);
    for (int i = 0; i < page->mark_count && status == FIG_OK; i++)
        if (page->marks[i].kind == FIG_MARK_PANEL)
            status = draw_panel(renderer, page->marks[i].panel,
                                fig_page_raster(page), cairo);
        else
            fig_mark_draw(&page->marks[i], theme, cairo);
    fig_renderer_free(own);
    cairo_restore(cairo);
    if (status == FIG_OK && !fig_page_place_tags(page))
        status = FIG_NO_MEMORY;
    if (status == FIG_OK)
        fig_page_draw_tags(page, cairo);
    fig_page_draw_heading(page, cairo);
    if (status == FIG_OK && cairo_status(cairo) != CAIRO_STATUS_SUCCESS)
        status = FIG_NO_MEMORY;
    return status;
}

// Files ------------------------------------------------------------------

/// A file, and the errno of the first failure or 0.
typedef struct sink {
    FILE *stream;
    int error;
} sink;

static bool put_bytes(sink *s, const void *bytes, size_t count)
{
    if (s->error == 0 && fwrite(bytes, 1, count, s->stream) != count)
        s->error = errno != 0 ? errno : EIO;
    return s->error == 0;
}

static fig_status close_sink(sink *s, fig_status status)
{
    if (fclose(s->stream) != 0 && s->error == 0)
        s->error = errno != 0 ? errno : EIO;
    if (s->error != 0 && (status == FIG_OK || status == FIG_UNWRITABLE)) {
        errno = s->error;
        return FIG_UNWRITABLE;
    }
    return status;
}

// Vector files -----------------------------------------------------------

static cairo_status_t put_for_cairo(void *closure, const unsigned char *bytes,
                                    unsigned count)
{
    return put_bytes(closure, bytes, count) ? CAIRO_STATUS_SUCCESS
                                            : CAIRO_STATUS_WRITE_ERROR;
}

static cairo_surface_t *new_pdf(sink *s, double width, double height)
{
    cairo_surface_t *surface =
        cairo_pdf_surface_create_for_stream(put_for_cairo, s, width, height);
    // The same page makes the same file on any day.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
    return surface;
}

static cairo_surface_t *new_svg(sink *s, double width, double height)
{
    return cairo_svg_surface_create_for_stream(put_for_cairo, s, width, height);
}

typedef cairo_surface_t *vector_surface(sink *s, double width, double height);

/// Let `cairo` count in points of the page, what is shown of it being fitted to
/// paper of that size.
static void fit_to_paper(const fig_page *page, double width, double height,
                         cairo_t *cairo)
{
    const fig_box *box = &page->shown;
    double scale = fmin(width / box->width, height / box->height);
    cairo_translate(cairo, (width - scale * box->width) / 2,
                    (height - scale * box->height) / 2);
    cairo_scale(cairo, scale, scale);
    cairo_translate(cairo, -box->x, -box->y);
}

static fig_status write_vectors(fig_page *page, sink *s,
                                vector_surface *new_surface)
{
    const fig_page_options *o = &page->options;
    double width = o->paper_x > 0 ? o->paper_x : page->shown.width;
    double height = o->paper_y > 0 ? o->paper_y : page->shown.height;
    cairo_surface_t *surface = new_surface(s, width, height);
    cairo_surface_set_fallback_resolution(surface, fallback_dpi, fallback_dpi);
    cairo_t *cairo = cairo_create(surface);
    fit_to_paper(page, width, height, cairo);
    fig_status status = draw_page(page, cairo);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    if (status == FIG_OK &&
        cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS)
        status = s->error != 0 ? FIG_UNWRITABLE : FIG_NO_MEMORY;
    cairo_surface_destroy(surface);
    return status;
}

static fig_status write_pdf(fig_page *page, sink *s)
{
    return write_vectors(page, s, new_pdf);
}

static fig_status write_svg(fig_page *page, sink *s)
{
    return write_vectors(page, s, new_svg);
}

// PNG --------------------------------------------------------------------

static void put_for_png(png_structp png, png_bytep bytes, png_size_t count)
{
    if (!put_bytes(png_get_io_ptr(png), bytes, count))
        png_error(png, "write");
}

static void flush_for_png(png_structp png)
{
    (void)png;
}

/// Errors are told by the status, not by libpng.
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

/// From cairo's pixel, colours times opacity, to PNG's four bytes.
static void convert_row(const unsigned char *row, int width, png_bytep out)
{
    for (int x = 0; x < width; x++, row += 4, out += 4) {
        unsigned pixel;
        memcpy(&pixel, row, 4);
        unsigned opacity = pixel >> 24;
        for (int k = 0; k < 3; k++) {
            unsigned c = pixel >> (16 - 8 * k) & 255;
            out[k] =
                (png_byte)(opacity == 0 ? 0
                                        : (c * 255 + opacity / 2) / opacity);
        }
        out[3] = (png_byte)opacity;
    }
}

static void put_rows(png_structp png, cairo_surface_t *surface, png_bytep row)
{
    const unsigned char *bytes = cairo_image_surface_get_data(surface);
    size_t stride = (size_t)cairo_image_surface_get_stride(surface);
    for (int y = 0; y < cairo_image_surface_get_height(surface); y++) {
        convert_row(bytes + stride * (size_t)y,
                    cairo_image_surface_get_width(surface), row);
        png_write_row(png, row);
    }
}

static fig_status put_png(sink *s, cairo_surface_t *surface, double dpi,
                          bool transparent)
{
    int width = cairo_image_surface_get_width(surface);
    png_bytep row = malloc(4 * (size_t)width);
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, fail, ignore);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    fig_status status = FIG_NO_MEMORY;
    if (row != NULL && info != NULL && setjmp(png_jmpbuf(png)) == 0) {
        png_set_write_fn(png, s, put_for_png, flush_for_png);
        png_set_IHDR(png, info, (png_uint_32)width,
                     (png_uint_32)cairo_image_surface_get_height(surface), 8,
                     transparent ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_uint_32 per_meter = (png_uint_32)lround(dpi / 0.0254);
        png_set_pHYs(png, info, per_meter, per_meter, PNG_RESOLUTION_METER);
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_write_info(png, info);
        if (!transparent)
            png_set_filler(png, 0, PNG_FILLER_AFTER);
        put_rows(png, surface, row);
        png_write_end(png, info);
        status = FIG_OK;
    }
    png_destroy_write_struct(&png, &info);
    free(row);
    return status == FIG_OK || s->error == 0 ? status : FIG_UNWRITABLE;
}

/// The page as pixels; the caller destroys the surface.
static fig_status draw_pixels(fig_page *page, cairo_surface_t **surface)
{
    fig_raster raster = fig_page_raster(page);
    *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.pixels_x,
                                          raster.pixels_y);
    cairo_t *cairo = cairo_create(*surface);
    cairo_translate(cairo, raster.shift_x, raster.shift_y);
    cairo_scale(cairo, raster.scale, raster.scale);
    fig_status status = draw_page(page, cairo);
    cairo_destroy(cairo);
    cairo_surface_flush(*surface);
    return status;
}

static fig_status write_png(fig_page *page, sink *s)
{
    cairo_surface_t *surface;
    fig_status status = draw_pixels(page, &surface);
    if (status == FIG_OK)
        status =
            put_png(s, surface,
                    page->options.dpi > 0 ? page->options.dpi
                                          : 72 * fig_page_raster(page).scale,
                    page->options.transparent);
    cairo_surface_destroy(surface);
    return status;
}

fig_status fig_page_paint(fig_page *page, uint32_t pixels[])
{
    const size_t width = (size_t)page->options.pixels_x;
    cairo_surface_t *surface;
    fig_status status = draw_pixels(page, &surface);
    for (int y = 0; y < page->options.pixels_y && status == FIG_OK; y++)
        memcpy(pixels + width * (size_t)y,
               cairo_image_surface_get_data(surface) +
                   (size_t)cairo_image_surface_get_stride(surface) * (size_t)y,
               width * sizeof *pixels);
    cairo_surface_destroy(surface);
    return status;
}

// Any --------------------------------------------------------------------

typedef fig_status writer(fig_page *page, sink *s);

static writer *writer_for(const char *path)
{
    static const struct {
        const char *ending;
        writer *write;
    } kinds[] = {{".png", write_png}, {".pdf", write_pdf}, {".svg", write_svg}};
    size_t length = strlen(path);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (length >= 4 && strcmp(path + length - 4, kinds[i].ending) == 0)
            return kinds[i].write;
    return NULL;
}

fig_status fig_page_write(fig_page *page, const char *path)
{
    writer *write = writer_for(path);
    if (write == NULL)
        return FIG_UNKNOWN_KIND;
    sink s = {.stream = fopen(path, "wb")};
    if (s.stream == NULL)
        return FIG_UNWRITABLE;
    return close_sink(&s, write(page, &s));
}
