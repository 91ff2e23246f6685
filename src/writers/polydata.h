//: Declare the PolyData of VTK
#pragma once

#include "formats/columns.h"

#include <stdint.h>
#include <stdio.h>

/// An array of VTK: rows of numbers, or of integers, so many a row.
typedef struct tf_polydata_array {
    const char *name;
    tf_number_type type; ///< that is written
    int components;      ///< of a row
    size_t rows;
    const double *number; ///< or NULL
    size_t stride;        ///< from a row of numbers to the next; components
                          ///< from there on are 0
    const int *integer;   ///< if there are no numbers; NULL: they count
    int first, step;      ///< from this one by this step
} tf_polydata_array;

/// Cells: the points of all of them, one after the other, and after each cell
/// how many points there are so far.
typedef struct tf_polydata_cells {
    tf_polydata_array points, ends;
} tf_polydata_cells;

enum {
    TF_MOST_ARRAYS = TF_MOST_COLUMNS + 1
};

/// Points, what they have, and the cells that they make.
typedef struct tf_polydata {
    tf_polydata_array position;
    int arrays;
    tf_polydata_array array[TF_MOST_ARRAYS];
    tf_polydata_cells verts, lines, polys;
} tf_polydata;

//: Declare how to write PolyData
/// Writes VTK's XML format of PolyData (.vtp) with raw appended data.
void tf_polydata_write(FILE *stream, const tf_polydata *data);

//: Declare how to make PolyData
/// Points without arrays and cells, three coordinates or two for each.
tf_polydata tf_polydata_of(size_t points, const double position[], int axes);

/// Adds an array to those of the points, unless there are too many.
void tf_polydata_add(tf_polydata *data, const tf_polydata_array *array);

/// Cells of so many corners each, which borrow the points of the corners; or of
/// one each, in order, if these are NULL.
tf_polydata_cells tf_polydata_cells_of(size_t cells, int corners,
                                       const int corner[]);
