#define _GNU_SOURCE // open_memstream
#include "draw/drawing.h"

#include "draw/encoder.h"
#include "draw/sheet.h"
#include "files/fault.h"
#include "files/output_file.h"
#include "files/visible.h"
#include "renderer/render.h"

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    PICTURE_WIDTH = 1600, ///< pixels, by default
    FILM_WIDTH = 960,
    CSS_DPI = 96, ///< pixels per inch of paper, by default
    SHARP = 2,    ///< pixels of a picture in a vector file for each of them
    BAR = 30      ///< letters of the progress bar
};

/// How far above the horizon a turntable's camera is by default.
static const double turntable_elevation = 22;

/// A drawing on its way to files.
typedef struct work {
    const fig_drawing *drawing;
    const fig_settings *settings;
    fig_page_options options; ///< of the next page
    fig_box panel;            ///< the one that is drawn, on the page
    fig_box box;              ///< what the pages show, without the title
    fig_renderer *renderer;   ///< of all pages
    int pages;                ///< drawn so far
    FILE *numbers;            ///< of the first page
    FILE *ignored;            ///< numbers of the other pages
} work;

// Errors -----------------------------------------------------------------

/// Print an error; false, for the caller to return.
__attribute__((format(printf, 2, 3))) static bool
report(const char *path, const char *format, ...)
{
    fprintf(stderr, "tanglefree-draw: %s: ", tf_make_visible(path).text);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}

static bool report_unwritable(const char *path)
{
    tf_fault fault;
    tf_fault_set_unwritten(&fault, path, errno);
    tf_fault_print(&fault, "tanglefree-draw");
    return false;
}

static bool report_page(const char *path, fig_status status)
{
    return status == FIG_UNWRITABLE
               ? report_unwritable(path)
               : report(path, "%s", fig_status_message(status));
}

static bool report_encoder(const char *path, int error)
{
    return error == EPIPE ? report(path, "ffmpeg failed; see its message above")
                          : report(path, "cannot send a frame to ffmpeg: %s",
                                   strerror(error));
}

// Pages ------------------------------------------------------------------

/// The height of what a picture shows, title and all, in points.
static double shown_height(const work *w)
{
    double title = w->settings->title ? fig_page_heading_height(w->box) : 0;
    return w->box.height + title;
}

/// How many pixels a page of the work gets, `width` of them wide by default.
static void set_size(work *w, int width)
{
    const fig_settings *settings = w->settings;
    double height =
        settings->shape > 0 ? settings->shape * w->box.width : shown_height(w);
    double side =
        settings->panel > 0 ? fmax(w->box.width, height) : w->box.width;
    double scale = settings->dpi > 0 ? settings->dpi / 72.0 : width / side;
    bool told = settings->pixels_x > 0;
    w->options.pixels_x =
        told ? settings->pixels_x : (int)lround(scale * w->box.width);
    w->options.pixels_y =
        told ? settings->pixels_y : (int)lround(scale * height);
}

/// The paper of a vector file: of a size in pixels, or of a shape.
static void set_paper(work *w)
{
    const fig_settings *settings = w->settings;
    if (settings->pixels_x > 0) {
        double points = 72.0 / (settings->dpi > 0 ? settings->dpi : CSS_DPI);
        w->options.paper_x = settings->pixels_x * points;
        w->options.paper_y = settings->pixels_y * points;
        int most = settings->pixels_x > settings->pixels_y ? settings->pixels_x
                                                           : settings->pixels_y;
        if (settings->dpi == 0 && most <= FIG_PIXELS_MOST / SHARP) {
            w->options.pixels_x *= SHARP;
            w->options.pixels_y *= SHARP;
        }
    } else if (settings->shape > 0) {
        w->options.paper_x = w->box.width;
        w->options.paper_y = w->box.width * settings->shape;
    }
}

static fig_page_options options_of(work *w)
{
    const fig_settings *settings = w->settings;
    return (fig_page_options){
        .width = w->drawing->width,
        .height = w->drawing->height,
        .theme = settings->theme,
        .dpi = settings->dpi,
        .transparent = settings->transparent,
        .bare = settings->bare,
        .turned = settings->turned,
        .azimuth = settings->azimuth,
        .elevation = settings->elevation,
        .renderer = &w->renderer,
    };
}

/// Find the box of the panel to draw, and what is shown of it.  False: there is
/// no such panel.
static bool find_panel(work *w, fig_page *page)
{
    int wanted = w->settings->panel, parts = fig_page_parts(page);
    if (wanted <= parts) {
        w->panel = fig_page_part(page, wanted - 1);
        w->box = fig_page_crop(page, w->panel);
        return true;
    }
    if (parts == 0)
        return report("--panel", "the picture has no panels; drop the option");
    return report("--panel",
                  "there is no panel %d; they are numbered from 1 to %d, row "
                  "by row",
                  wanted, parts);
}

/// Draw the first page to find what is shown of all pages.
static bool find_box(work *w)
{
    w->box = (fig_box){0, 0, w->drawing->width, w->drawing->height};
    if (w->settings->panel == 0)
        return true;
    fig_page_options options = w->options;
    options.pixels_x = options.pixels_y = FIG_PIXELS_LEAST;
    fig_page *page;
    fig_status status = fig_page_new(&options, &page);
    bool found = status == FIG_OK || report_page("--panel", status);
    if (found) {
        w->drawing->draw(w->drawing->subject, page, w->ignored);
        found = find_panel(w, page);
    }
    fig_page_free(page);
    return found;
}

/// Draw a page, and hand it to `put`.
static bool draw_page(work *w, const char *path,
                      fig_status (*put)(fig_page *page, void *to), void *to)
{
    FILE *numbers = w->pages++ == 0 ? w->numbers : w->ignored;
    fig_page *page;
    fig_status status = fig_page_new(&w->options, &page);
    if (status == FIG_OK) {
        w->drawing->draw(w->drawing->subject, page, numbers);
        if (w->settings->panel > 0)
            fig_page_crop(page, w->panel);
        if (w->settings->title)
            fig_page_heading(page, w->settings->title);
        status = put(page, to);
    }
    fig_page_free(page);
    return status == FIG_OK || report_page(path, status);
}

static fig_status put_file(fig_page *page, void *path)
{
    return fig_page_write(page, path);
}

static fig_status put_pixels(fig_page *page, void *pixels)
{
    return fig_page_paint(page, pixels);
}

// The picture ------------------------------------------------------------

/// Draw the next page to a file.
static bool draw_to(work *w, const char *path)
{
    tf_output_file file;
    if (!tf_output_file_begin(&file, path))
        return report_unwritable(path);
    bool made = draw_page(w, path, put_file, file.scratch);
    if (made && !tf_output_file_keep(&file))
        made = report_unwritable(path);
    tf_output_file_drop(&file);
    return made;
}

static bool make_picture(work *w)
{
    w->options = options_of(w);
    if (!find_box(w))
        return false;
    set_size(w, PICTURE_WIDTH);
    if (!fig_path_ends(w->settings->picture, ".png"))
        set_paper(w);
    return draw_to(w, w->settings->picture);
}

// The film ---------------------------------------------------------------

/// Set the page of the i-th picture.  A turn ends where it began, so its last
/// picture is the one before that; time runs from 0 to 1.
static void set_frame(work *w, int i)
{
    const fig_settings *settings = w->settings;
    int last = settings->frames > 1 ? settings->frames - 1 : 1;
    if (!settings->turntable) {
        w->options.time = (double)i / last;
        return;
    }
    w->options.turned = true;
    w->options.azimuth = settings->azimuth + 360.0 * i / settings->frames;
    w->options.elevation =
        settings->turned ? settings->elevation : turntable_elevation;
}

tf_progress_line fig_progress_begin(void)
{
    return tf_progress_line_begin(true);
}

void fig_progress_show(tf_progress_line *progress, int done, int count,
                       const char *things)
{
    char text[BAR + 64];
    int full = (int)((long)BAR * done / count);
    snprintf(text, sizeof text, "of %d %s [%.*s%*s]", count, things, full,
             "##############################", BAR - full, "");
    tf_progress_line_show(progress, done, text);
}

/// A film in the making: its frames go to files of their own in a folder,
/// through a file to an encoder, or as pixels to a sheet.
typedef struct film {
    const char *path; ///< for messages, or the folder
    char *frame;      ///< the file; NULL: there is no encoder
    fig_encoder encoder;
    uint32_t *pixels;
    fig_sheet *sheet; ///< NULL: there is none
} film;

/// Draw the i-th frame to the file "FOLDER/frame-00000.png" of that number.
static bool draw_to_folder(work *w, const char *folder, int i)
{
    char *path;
    if (asprintf(&path, "%sframe-%05d.png", folder, i) < 0)
        return report_page(folder, FIG_NO_MEMORY);
    bool made = draw_to(w, path);
    free(path);
    return made;
}

static bool add_frame(work *w, film *f, int i)
{
    if (!f->frame && !f->sheet)
        return draw_to_folder(w, f->path, i);
    if (!f->frame)
        return draw_page(w, f->path, put_pixels, f->pixels) &&
               (fig_sheet_add(f->sheet, f->pixels) ||
                report_page(f->path, FIG_NO_MEMORY));
    return draw_page(w, f->path, put_file, f->frame) &&
           (fig_encoder_add(&f->encoder, f->frame) ||
            report_encoder(f->path, errno));
}

static bool add_frames(work *w, film *f)
{
    const fig_settings *settings = w->settings;
    tf_progress_line progress = fig_progress_begin();
    bool added = true;
    for (int i = 0; i < settings->frames && added; i++) {
        fig_progress_show(&progress, i, settings->frames, "frames");
        set_frame(w, i);
        added = add_frame(w, f, i);
    }
    tf_progress_line_end(&progress);
    return added;
}

/// Encode the film to the file at `scratch`, by way of the file at `frame`.
static bool encode(work *w, const char *scratch, char *frame)
{
    film f = {.path = w->settings->film, .frame = frame};
    if (!fig_encoder_begin(&f.encoder, scratch, w->settings->fps))
        return report(f.path,
                      "cannot run ffmpeg, which makes the film: %s; "
                      "install it (on Debian, the package ffmpeg)",
                      strerror(errno));
    tf_output_file_writer(f.encoder.process);
    bool added = add_frames(w, &f);
    bool ended = fig_encoder_end(&f.encoder);
    tf_output_file_writer(0);
    return added && (ended || report_encoder(f.path, EPIPE));
}

static bool encode_by_file(work *w, const char *scratch)
{
    const char *folder = getenv("TMPDIR");
    char frame_path[4096];
    snprintf(frame_path, sizeof frame_path, "%s/picture.png",
             folder && *folder ? folder : "/tmp");
    tf_output_file frame;
    bool made = tf_output_file_begin(&frame, frame_path)
                    ? encode(w, scratch, frame.scratch)
                    : report_unwritable(frame_path);
    tf_output_file_drop(&frame);
    return made;
}

/// Write the film as a sheet to the file at `scratch`.
static bool write_sheet(work *w, const char *scratch)
{
    int width = w->options.pixels_x, height = w->options.pixels_y;
    film f = {.path = w->settings->film,
              .pixels =
                  calloc((size_t)width * (size_t)height, sizeof *f.pixels),
              .sheet = fig_sheet_new(width, height)};
    bool made = f.pixels && f.sheet ? add_frames(w, &f)
                                    : report_page(f.path, FIG_NO_MEMORY);
    if (made && !fig_sheet_write(f.sheet, scratch))
        made = report_unwritable(f.path);
    fig_sheet_free(f.sheet);
    free(f.pixels);
    return made;
}

/// Write the film as pictures in a folder, which is made if it is not there.
static bool write_pictures(work *w)
{
    film f = {.path = w->settings->film};
    if (mkdir(f.path, 0777) != 0 && errno != EEXIST)
        return report_unwritable(f.path);
    return add_frames(w, &f);
}

static bool make_film(work *w)
{
    const char *path = w->settings->film;
    w->options = options_of(w);
    w->options.moves = !w->settings->turntable;
    if (!find_box(w))
        return false;
    set_size(w, FILM_WIDTH);
    if (fig_path_is_folder(path))
        return write_pictures(w);
    tf_output_file file;
    if (!tf_output_file_begin(&file, path))
        return report_unwritable(path);
    bool made = fig_path_ends(path, ".png") ? write_sheet(w, file.scratch)
                                            : encode_by_file(w, file.scratch);
    if (made && !tf_output_file_keep(&file))
        made = report_unwritable(path);
    tf_output_file_drop(&file);
    return made;
}

// Both -------------------------------------------------------------------

static bool make_all(work *w)
{
    return (!w->settings->picture || make_picture(w)) &&
           (!w->settings->film || make_film(w));
}

static bool print(const char *numbers)
{
    fputs(numbers, stdout);
    return fflush(stdout) == 0 || report_unwritable("standard output");
}

int fig_drawing_make(const fig_drawing *drawing, const fig_settings *settings)
{
    char *numbers = NULL;
    size_t length;
    work w = {.drawing = drawing,
              .settings = settings,
              .numbers = open_memstream(&numbers, &length),
              .ignored = fopen("/dev/null", "w")};
    bool made = w.numbers && w.ignored
                    ? make_all(&w)
                    : report("/dev/null", "%s", strerror(errno));
    fig_renderer_free(w.renderer);
    if (w.ignored)
        fclose(w.ignored);
    if (w.numbers)
        fclose(w.numbers);
    made = made && print(numbers);
    free(numbers);
    return made ? 0 : 2;
}
