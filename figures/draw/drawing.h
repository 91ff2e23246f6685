// Something to draw, and what the settings make of it: a picture, a film.
#ifndef TF_DRAW_DRAWING_H
#define TF_DRAW_DRAWING_H

#include "draw/settings.h"
#include "stage/page.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct tf_drawing {
    double width, height; ///< of the page, points
    const void *subject;  ///< borrowed
    /// Draw on an empty page of that size.  Numbers go to `numbers`, a line "key
    /// value" each.
    void (*draw)(const void *subject, tf_page *page, FILE *numbers);
} tf_drawing;

/// Draw what the settings ask for, then print the numbers to standard output.
/// Returns the exit status, 0 or 2; in the latter case standard error has
/// been told why, and a file is either whole or as it was before.
int tf_drawing_make(const tf_drawing *drawing, const tf_settings *settings);

#endif
