// Something to draw, and what the settings make of it: a picture, a film.
#ifndef FIG_DRAW_DRAWING_H
#define FIG_DRAW_DRAWING_H

#include "draw/settings.h"
#include "program/progress.h"
#include "renderer/page.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct fig_drawing {
    double width, height; ///< of the page, points
    const void *subject;  ///< borrowed
    /// Draw on an empty page of that size.  Numbers go to `numbers`, a line
    /// "key value" each.
    void (*draw)(const void *subject, fig_page *page, FILE *numbers);
} fig_drawing;

/// Draw what the settings ask for, then print the numbers to standard output.
/// Returns the exit status, 0 or 2; in the latter case standard error has
/// been told why, and a file is either whole or as it was before.
int fig_drawing_make(const fig_drawing *drawing, const fig_settings *settings);

/// A line on the terminal about the frames of a film, with a bar.  Numbers are
/// printed at the end, so it may share the terminal with standard output.
tf_progress_line fig_progress_begin(void);
void fig_progress_show(tf_progress_line *progress, int done, int count,
                       const char *things);

#endif
