// What to make of a drawing: the options that the commands share.
#ifndef FIG_DRAW_SETTINGS_H
#define FIG_DRAW_SETTINGS_H

#include "kit/surface_shape.h"
#include "renderer/theme.h"

#include <argp.h>
#include <stdbool.h>

typedef struct fig_settings {
    const char *picture;    ///< the file; NULL: none
    const char *film;       ///< the file, or a folder with a slash at its end
                            ///< for pictures of its frames; NULL: none
    int pixels_x, pixels_y; ///< 0: unless `dpi` tells, as many as are usual
    double shape;           ///< its height by its width; 0: not told
    const char *title;      ///< a line above the picture; NULL: none
    int panel;              ///< the only one to draw, from 1; 0: all
    bool bare;              ///< without labels
    const char *names;      ///< labels of the user's own; NULL: none
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

/// Refuse own names where there is nothing to give them to.
void fig_refuse_names(struct argp_state *state, const fig_settings *settings);

/// Refuse text of an option that is not in the notation of letters.h.
void fig_check_text(struct argp_state *state, const char *option,
                    const char *text);

/// The same for a command that makes films of given frames: without what is
/// about time, turns and print.
extern const struct argp_child fig_settings_film_options[];

/// The row of a letter that an option had before 1.0, and what refuses it until
/// 2.0; `now` is the option.
#define FIG_OLD_LETTER(letter)                                                 \
    {                                                                          \
        NULL, letter, "",                                                      \
            OPTION_ARG_OPTIONAL | OPTION_HIDDEN | OPTION_NO_USAGE, NULL, 0     \
    }
void fig_refuse_letter(struct argp_state *state, char letter, const char *now);

/// A number of an option, from `least` to `most`; an error ends the program.
int fig_read_count(struct argp_state *state, const char *option,
                   const char *text, int least, int most);

/// An axis that points up, x, y or z; an error ends the program.
fig_up fig_read_up(struct argp_state *state, const char *text);

/// A time of the step, from 0 to 1; an error ends the program.
double fig_read_time(struct argp_state *state, const char *option,
                     const char *text);

/// Whether a path ends in that ending, ".png" for instance.
bool fig_path_ends(const char *path, const char *ending);

/// Whether a path ends in a slash.
bool fig_path_is_folder(const char *path);

#endif
