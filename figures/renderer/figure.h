// What a figure is to the program that draws it.
#ifndef FIG_RENDERER_FIGURE_H
#define FIG_RENDERER_FIGURE_H

#include "renderer/page.h"

#include <stdio.h>

/// The size of the usual figure, and of its picture.
#define FIG_PAGE_WIDTH 384.0
#define FIG_PAGE_HEIGHT 288.0
enum {
    FIG_PAGE_PIXELS_X = 1600,
    FIG_PAGE_PIXELS_Y = 1200
};

typedef struct fig_figure {
    const char *name;     ///< of its files, without ending
    const char *title;    ///< a line for a listing
    double width, height; ///< points
    bool moves;           ///< draws other pages for other times in a film
    /// Draw on an empty page of that size.  Numbers that the caption cites go
    /// to `numbers`, a line "key value" each, the same for every theme.
    void (*draw)(fig_page *page, FILE *numbers);
} fig_figure;

/// Print a line "key value", %.17g cut to the shortest that reads back; whole
/// numbers below 2^52 are written out.
void fig_number(FILE *numbers, const char *key, double value);

#endif
