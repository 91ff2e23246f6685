//: Declare a grid of cells
#pragma once

#include "surface/buffer.h"
#include "untangle/neighbors.h"

/// A box along the axes, in the plane 0 along the last one.
typedef struct tf_cell_box {
    double low[3], high[3];
} tf_cell_box;

/// A grid of cubes that tells what is near some boxes.  Each box is taken for
/// all cells that it reaches; so boxes that overlap have a cell in common.
typedef struct tf_cells {
    double low[3], size; ///< where the grid begins, and the size of a cell
    int count[3];        ///< cells along each axis
    int *sum; ///< of the boxes in a cell; after tf_cells_sum, how many cells
              ///< with a box there are from the first one to this one
    tf_buffer storage;
} tf_cells;

/// Begins a grid without boxes over all that is at x, with cells not smaller
/// than `size`, which is positive, and not many more than `most`.  False if
/// there is no memory.
bool tf_cells_begin(tf_cells *cells, const tf_neighbors *all, const double x[],
                    double size, int most);

void tf_cells_free(tf_cells *cells);

//: Declare how cells are asked
/// Adds a box.
void tf_cells_add(tf_cells *cells, const tf_cell_box *box);

/// Ends to add boxes.  Only then cells can be asked.
void tf_cells_sum(tf_cells *cells);

/// Whether a box reaches a cell that an added box reaches.
bool tf_cells_touch(const tf_cells *cells, const tf_cell_box *box);

/// Whether each cell that a box reaches is one that an added box reaches.
bool tf_cells_cover(const tf_cells *cells, const tf_cell_box *box);
