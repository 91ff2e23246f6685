// Coordinates of any size, brought into a box that can be drawn.
#ifndef FIG_FIT_H
#define FIG_FIT_H

#include "renderer/vector.h"

#include <stdbool.h>

/// A length fraction 2^exponent, perhaps beyond the doubles: 0.5 <= fraction
/// < 1, or 0.
typedef struct fig_span {
    double fraction;
    int exponent;
} fig_span;

/// How points were fitted.
typedef struct fig_fit {
    fig_span span[3]; ///< from the least coordinate to the greatest
    bool alike;       ///< all axes were scaled alike; otherwise each by itself
} fig_fit;

/// Map finite points, axis by axis and linearly, into the cube from -1/2 to
/// 1/2, the longest span to its full side.  Axes whose spans are of very
/// different lengths are scaled each by itself: every span that is not zero
/// then fills a side.  Coordinates from `axes` on become 0.
fig_fit fig_fit_points(int axes, int count, tf_vector point[]);

/// Map finite points into that cube, all axes scaled alike.
fig_fit fig_fit_points_alike(int axes, int count, tf_vector point[]);

enum {
    FIG_NUMBER_TEXT = 32
}; ///< room for a number's text

/// Write a span or a finite number with up to four digits, as mathematics: 3 or
/// 2.5×10^{22}.  Returns whether the digits are all of the number.
bool fig_span_text(fig_span span, char text[FIG_NUMBER_TEXT]);
bool fig_number_text(double number, char text[FIG_NUMBER_TEXT]);

enum {
    FIG_TIME_TEXT = 64
}; ///< room for a time's text

/// Write "t = 0.5", or "t ≈ 0.3333" where more digits follow, with $.
void fig_time_text(double t, char text[FIG_TIME_TEXT]);

#endif
