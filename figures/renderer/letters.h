// Letters: text with a little mathematics, set by Pango.
//
// In text, $...$ is mathematics: letters become italic, - a minus sign and ' a
// prime; x_0 and x_{ij} lower, x^2 and x^{-1} raise, and in x_0' the prime
// stands over the 0; \bar{x} draws a bar over x; \up{det} keeps letters
// upright; \b{x} is bold.  Any other letter or sign is written as it is, in
// UTF-8: Δ, ≥, ×.  Outside of $...$, *word* is italic.  \$, \* and \\ are the
// signs themselves.
#ifndef FIG_RENDERER_LETTERS_H
#define FIG_RENDERER_LETTERS_H

#include "renderer/status.h"
#include "renderer/theme.h"

#include <cairo.h>
#include <stdbool.h>

#define FIG_LETTERS_FAMILY "STIXGeneral"

/// Text that was set: a size, and what it takes to draw it.
typedef struct fig_letters fig_letters;

/// Whether fontconfig knows a font family of that name.
bool fig_letters_known(const char *family);

/// Set text in letters of `size` points.  *letters is NULL after a failure.
fig_status fig_letters_set(const char *family, const char *text, double size,
                           fig_letters **letters);

void fig_letters_free(fig_letters *letters);

/// The extent of the ink, around (0, 0) at the left end of the first baseline,
/// in points.
void fig_letters_ink(const fig_letters *letters, double *x, double *y,
                     double *width, double *height);

/// How far the letters go to the right, in points, as type is spaced.
double fig_letters_advance(const fig_letters *letters);

/// Draw letters at (x, y) as below, but only a border of `width` points around
/// them, `opacity` strong: letters in front of lines stay legible.
void fig_letters_clear(const fig_letters *letters, cairo_t *cairo, double x,
                       double y, double width, fig_rgb color, double opacity);

/// Draw with the left end of the first baseline at (x, y), in cairo's user
/// space, which is in points.
void fig_letters_draw(const fig_letters *letters, cairo_t *cairo, double x,
                      double y, fig_rgb color);

#endif
