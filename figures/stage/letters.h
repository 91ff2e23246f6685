// Letters: text with a little mathematics, set by Pango.
//
// In text, $...$ is mathematics: letters become italic, - a minus sign and ' a
// prime; x_0 and x_{ij} lower, x^2 and x^{-1} raise, and in x_0' the prime
// stands over the 0; \bar{x} draws a bar over x; \up{det} keeps letters
// upright; \b{x} is bold.  Any other letter or sign is written as it is, in
// UTF-8: Δ, ≥, ×.  Outside of $...$, *word* is italic.  \$, \* and \\ are the
// signs themselves.
#ifndef TF_STAGE_LETTERS_H
#define TF_STAGE_LETTERS_H

#include "stage/status.h"
#include "stage/theme.h"

#include <cairo.h>
#include <stdbool.h>

#define TF_LETTERS_FAMILY "STIXGeneral"

/// Text that was set: a size, and what it takes to draw it.
typedef struct tf_letters tf_letters;

/// Whether fontconfig knows a font family of that name.
bool tf_letters_known(const char *family);

/// Set text in letters of `size` points.  *letters is NULL after a failure.
tf_stage_status tf_letters_set(const char *family, const char *text,
                               double size, tf_letters **letters);

void tf_letters_free(tf_letters *letters);

/// The extent of the ink, around (0, 0) at the left end of the first baseline,
/// in points.
void tf_letters_ink(const tf_letters *letters, double *x, double *y,
                    double *width, double *height);

/// How far the letters go to the right, in points, as type is spaced.
double tf_letters_advance(const tf_letters *letters);

/// Draw letters at (x, y) as below, but only a border of `width` points around
/// them, `opacity` strong: letters in front of lines stay legible.
void tf_letters_clear(const tf_letters *letters, cairo_t *cairo, double x,
                      double y, double width, tf_rgb color, double opacity);

/// Draw with the left end of the first baseline at (x, y), in cairo's user
/// space, which is in points.
void tf_letters_draw(const tf_letters *letters, cairo_t *cairo, double x,
                     double y, tf_rgb color);

#endif
