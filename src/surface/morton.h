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

/// A part of space, cut into TF_CELLS cells along each axis.
typedef struct tf_morton_grid {
    float low[TF_AXES];
    float cells[TF_AXES]; ///< to a unit of length
} tf_morton_grid;

/// The grid of where everything starts, for sums of some number of paths.
tf_morton_grid tf_morton_grid_of(const tf_box *whole, int paths);

/// The place along the Morton curve through the grid of where a path starts:
/// the bits of the coordinates of its cell, shuffled.  What is on the high side
/// of the grid is in the last cell, and so is what roundings put beyond.
uint32_t tf_morton_key(const tf_path *path, const tf_morton_grid *grid);

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
