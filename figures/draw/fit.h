// Coordinates of any size, brought into a box that can be drawn.
#ifndef TF_DRAW_FIT_H
#define TF_DRAW_FIT_H

#include <stdbool.h>

/// A length fraction 2^exponent, perhaps beyond the doubles: 0.5 <= fraction
/// < 1, or 0.
typedef struct tf_span {
    double fraction;
    int exponent;
} tf_span;

/// How points were fitted.
typedef struct tf_fit {
    tf_span span[3]; ///< from the least coordinate to the greatest
    bool alike;      ///< all axes were scaled alike; otherwise each by itself
} tf_fit;

/// Map finite points, axis by axis and linearly, into the cube from -1/2 to
/// 1/2, the longest span to its full side.  Axes whose spans are of very
/// different lengths are scaled each by itself: every span that is not zero
/// then fills a side.  Coordinates from `axes` on become 0.
tf_fit tf_fit_points(int axes, int count, double point[][3]);

enum {
    TF_NUMBER_TEXT = 32
}; ///< room for a number's text

/// Write a span or a finite number with up to four digits, as mathematics: 3 or
/// 2.5×10^{22}.  Returns whether the digits are all of the number.
bool tf_span_text(tf_span span, char text[TF_NUMBER_TEXT]);
bool tf_number_text(double number, char text[TF_NUMBER_TEXT]);

#endif
