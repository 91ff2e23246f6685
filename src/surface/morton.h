//: Declare Morton order
#pragma once

#include "surface/box.h"
#include "surface/buffer.h"

#include <stdint.h>

enum {
    TF_CELLS = 1024 ///< along each axis, in the grid of the Morton curve
};

/// An element with the place of its box along the Morton curve.
typedef struct tf_keyed {
    uint32_t key; ///< 30 bits
    int element;
} tf_keyed;

/// The place of the box's center along the Morton curve through `whole`, which
/// is cut into TF_CELLS cells along each axis: the bits of the coordinates of
/// the center's cell, shuffled.  A center on the high side of `whole` is in the
/// last cell.
uint32_t tf_morton_key(const tf_box *box, const tf_box *whole);

//: Declare the sort
enum {
    TF_SORT_PART = 16384, ///< how many items a task of the sort has at least
    TF_SORT_PARTS = 64,   ///< how many tasks there are at most
    TF_DIGITS = 1024      ///< how many values a digit of the keys has
};

/// Room for a sort: a count for each digit, for each task.
typedef int tf_digit_counts[TF_DIGITS];

/// Sorts by key, those of equal keys in their order.  `from` and `to` have room
/// for `count` items, and `counts` for TF_SORT_PARTS; returns which of the two
/// has the result, and the other is overwritten.
tf_keyed *tf_morton_sort(int count, tf_keyed *from, tf_keyed *to,
                         tf_digit_counts *counts, const tf_parallel *parallel);
