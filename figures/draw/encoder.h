// Pictures become a film: ffmpeg reads them from a pipe.
#ifndef FIG_DRAW_ENCODER_H
#define FIG_DRAW_ENCODER_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

typedef struct fig_encoder {
    pid_t process;
    FILE *pipe; ///< takes PNG files, one after the other
} fig_encoder;

/// Start to make the film `path`, over what is there; its ending, .mp4, .gif or
/// .webp, tells its kind.  False, with errno (ENOENT: there is no ffmpeg), if
/// that fails.  A write to the pipe of an encoder that has died fails with
/// EPIPE.
bool fig_encoder_begin(fig_encoder *encoder, const char *path, int fps);

/// Add the picture in a PNG file.  False, with errno, if that fails.
bool fig_encoder_add(fig_encoder *encoder, const char *png);

/// Close the pipe and wait for the film.  False if ffmpeg has failed; it has
/// told why on standard error.
bool fig_encoder_end(fig_encoder *encoder);

#endif
