// What to make of a drawing: the options that the commands share.
#ifndef FIG_DRAW_SETTINGS_H
#define FIG_DRAW_SETTINGS_H

#include "renderer/theme.h"

#include <argp.h>
#include <stdbool.h>

typedef struct fig_settings {
    const char *picture;    ///< the file; NULL: none
    const char *film;       ///< the file, or a folder with a slash at its end
                            ///< for pictures of its frames; NULL: none
    int pixels_x, pixels_y; ///< 0: unless `dpi` tells, as many as are usual
    int dpi;                ///< pixels per inch; 0: not told
    const fig_theme *theme;
    bool transparent;
    bool turned; ///< look from:
    double azimuth, elevation;
    int frames, fps;
    bool turntable; ///< the film turns the camera; otherwise time passes
} fig_settings;

/// A child for the parsers of the commands.  Its input is a fig_settings, which
/// it sets to what is usual at first.
extern const struct argp_child fig_settings_options[];

/// The same for a command that makes films of given frames: without what is
/// about time, turns and print.
extern const struct argp_child fig_settings_film_options[];

/// A number of an option, from `least` to `most`; an error ends the program.
int fig_read_count(struct argp_state *state, const char *option,
                   const char *text, int least, int most);

/// Whether a path ends in that ending, ".png" for instance.
bool fig_path_ends(const char *path, const char *ending);

/// Whether a path ends in a slash.
bool fig_path_is_folder(const char *path);

#endif
