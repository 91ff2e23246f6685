#define _GNU_SOURCE // open_memstream
#include "draw/drawing.h"

#include "draw/encoder.h"
#include "draw/output_file.h"
#include "program/progress.h"

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    PICTURE_WIDTH = 1600, ///< pixels, unless told
    FILM_WIDTH = 960,
    BAR = 30 ///< letters of the progress bar
};

/// How far above the horizon a turntable's camera is, unless told.
static const double turntable_elevation = 22;

/// A drawing on its way to files.
typedef struct work {
    const tf_drawing *drawing;
    const tf_settings *settings;
    tf_page_options options; ///< of the next page
    int pages;               ///< drawn so far
    FILE *numbers; ///< of the first page; those of the others are not heard
    FILE *unheard;
} work;

// Complaints -------------------------------------------------------------

/// Tell what is wrong; false, for the caller to return.
__attribute__((format(printf, 2, 3))) static bool
complain(const char *path, const char *format, ...)
{
    fprintf(stderr, "tanglefree-draw: %s: ", path);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}

static bool complain_unwritable(const char *path)
{
    return complain(path, "cannot write: %s; name a file that can be written",
                    strerror(errno));
}

static bool complain_of_stage(const char *path, tf_stage_status status)
{
    return status == TF_STAGE_UNWRITABLE
               ? complain_unwritable(path)
               : complain(path, "%s", tf_stage_message(status));
}

static bool complain_of_encoder(const char *path, int error)
{
    return error == EPIPE
               ? complain(path, "ffmpeg has failed; its own words tell why")
               : complain(path, "cannot hand a picture to ffmpeg: %s",
                          strerror(error));
}

// Pages ------------------------------------------------------------------

/// How many pixels a page of the work gets, `width` of them wide unless told.
static void set_size(work *w, int width)
{
    const tf_settings *settings = w->settings;
    const tf_drawing *drawing = w->drawing;
    double scale =
        settings->dpi > 0 ? settings->dpi / 72.0 : width / drawing->width;
    bool told = settings->pixels_x > 0;
    w->options.pixels_x =
        told ? settings->pixels_x : (int)lround(scale * drawing->width);
    w->options.pixels_y =
        told ? settings->pixels_y : (int)lround(scale * drawing->height);
}

static tf_page_options options_of(const work *w)
{
    const tf_settings *settings = w->settings;
    return (tf_page_options){
        .width = w->drawing->width,
        .height = w->drawing->height,
        .theme = settings->theme,
        .dpi = settings->dpi,
        .transparent = settings->transparent,
        .turned = settings->turned,
        .azimuth = settings->azimuth,
        .elevation = settings->elevation,
    };
}

/// Draw a page to the file at `scratch`, which messages call `path`.
static bool draw_page(work *w, const char *scratch, const char *path)
{
    FILE *numbers = w->pages++ == 0 ? w->numbers : w->unheard;
    tf_page *page;
    tf_stage_status status = tf_page_new(&w->options, &page);
    if (status == TF_STAGE_OK) {
        w->drawing->draw(w->drawing->subject, page, numbers);
        status = tf_page_write(page, scratch);
    }
    tf_page_free(page);
    return status == TF_STAGE_OK || complain_of_stage(path, status);
}

// The picture ------------------------------------------------------------

static bool make_picture(work *w)
{
    const char *path = w->settings->picture;
    w->options = options_of(w);
    set_size(w, PICTURE_WIDTH);
    tf_output_file file;
    if (!tf_output_file_begin(&file, path))
        return complain_unwritable(path);
    bool made = draw_page(w, file.scratch, path);
    if (made && !tf_output_file_keep(&file))
        made = complain_unwritable(path);
    tf_output_file_drop(&file);
    return made;
}

// The film ---------------------------------------------------------------

/// Set the page of the i-th picture.  A turn ends where it began, so its last
/// picture is the one before that; time runs from 0 to 1.
static void set_frame(work *w, int i)
{
    const tf_settings *settings = w->settings;
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

static void show_progress(tf_progress *progress, int done, int frames)
{
    char things[BAR + 64];
    int full = (int)((long)BAR * done / frames);
    snprintf(things, sizeof things, "of %d pictures [%.*s%*s]", frames, full,
             "##############################", BAR - full, "");
    tf_progress_tell(progress, done, things);
}

static bool add_frames(work *w, tf_encoder *encoder, const char *frame)
{
    const tf_settings *settings = w->settings;
    tf_progress progress = tf_progress_begin();
    progress.wanted = isatty(STDERR_FILENO);
    bool added = true;
    for (int i = 0; i < settings->frames && added; i++) {
        show_progress(&progress, i, settings->frames);
        set_frame(w, i);
        added = draw_page(w, frame, settings->film);
        if (added && !tf_encoder_add(encoder, frame))
            added = complain_of_encoder(settings->film, errno);
    }
    tf_progress_end(&progress);
    return added;
}

/// Encode the film to the file at `scratch`.  `frame` takes a picture.
static bool encode(work *w, const char *scratch, const char *frame)
{
    const char *path = w->settings->film;
    tf_encoder encoder;
    if (!tf_encoder_begin(&encoder, scratch, w->settings->fps))
        return complain(path,
                        "cannot run ffmpeg, which makes the film: %s; "
                        "install it (on Debian, the package ffmpeg)",
                        strerror(errno));
    tf_output_file_writer(encoder.process);
    bool added = add_frames(w, &encoder, frame);
    bool ended = tf_encoder_end(&encoder);
    tf_output_file_writer(0);
    return added && (ended || complain_of_encoder(path, EPIPE));
}

static bool make_film(work *w)
{
    const char *path = w->settings->film;
    w->options = options_of(w);
    w->options.moves = !w->settings->turntable;
    set_size(w, FILM_WIDTH);
    const char *folder = getenv("TMPDIR");
    char frame_path[4096];
    snprintf(frame_path, sizeof frame_path, "%s/picture.png",
             folder && *folder ? folder : "/tmp");
    tf_output_file file, frame;
    if (!tf_output_file_begin(&file, path))
        return complain_unwritable(path);
    bool made = tf_output_file_begin(&frame, frame_path)
                    ? encode(w, file.scratch, frame.scratch)
                    : complain_unwritable(frame_path);
    if (made && !tf_output_file_keep(&file))
        made = complain_unwritable(path);
    tf_output_file_drop(&frame);
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
    return fflush(stdout) == 0 ||
           complain("standard output",
                    "cannot write: %s; mend that and run "
                    "again",
                    strerror(errno));
}

int tf_drawing_make(const tf_drawing *drawing, const tf_settings *settings)
{
    char *numbers = NULL;
    size_t length;
    work w = {.drawing = drawing,
              .settings = settings,
              .numbers = open_memstream(&numbers, &length),
              .unheard = fopen("/dev/null", "w")};
    bool made = w.numbers && w.unheard
                    ? make_all(&w)
                    : complain("/dev/null", "%s", strerror(errno));
    if (w.unheard)
        fclose(w.unheard);
    if (w.numbers)
        fclose(w.numbers);
    made = made && print(numbers);
    free(numbers);
    return made ? 0 : 2;
}
