// Doubles as rows of bits, one place below another.
#ifndef FIG_BIT_ROWS_H
#define FIG_BIT_ROWS_H

#include "renderer/figure.h"

/// Where the places of a picture are: that of 2^highest begins at `left`, and
/// each takes `cell`.
typedef struct fig_bit_rows {
    double left, cell, height;
    int highest, lowest; ///< exponents
} fig_bit_rows;

/// The place of a bit in the row from `y` on.
fig_box fig_bit_box(const fig_bit_rows *rows, int exponent, double y);

/// The 53 places of a double: ones full, zeros pale, and nothing beyond the
/// lowest place.
void fig_bits(fig_page *page, const fig_bit_rows *rows, double y, double x,
              fig_role role);

/// A name at the left of a row.
void fig_bits_name(fig_page *page, const fig_bit_rows *rows, double y,
                   const char *name, fig_role role);

/// Every tenth power of two, below all rows.
void fig_bits_scale(fig_page *page, const fig_bit_rows *rows, double y);

/// A dashed line after the place of 2^exponent.
void fig_bits_cut(fig_page *page, const fig_bit_rows *rows, int exponent,
                  double above, double below);

#endif
