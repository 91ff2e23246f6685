// Pictures become a film: ffmpeg reads them from a pipe.
#ifndef TF_DRAW_ENCODER_H
#define TF_DRAW_ENCODER_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

typedef struct tf_encoder {
    pid_t process;
    FILE *pipe; ///< takes PNG files, one after the other
} tf_encoder;

/// Start to make the film `path`, over what is there; its ending, .mp4, .gif or
/// .webp, tells its kind.  False, with errno (ENOENT: there is no ffmpeg), if
/// that fails.  A write to the pipe of an encoder that has died fails with
/// EPIPE.
bool tf_encoder_begin(tf_encoder *encoder, const char *path, int fps);

/// Add the picture in a PNG file.  False, with errno, if that fails.
bool tf_encoder_add(tf_encoder *encoder, const char *png);

/// Close the pipe and wait for the film.  False if ffmpeg has failed; it has
/// told why on standard error.
bool tf_encoder_end(tf_encoder *encoder);

#endif
