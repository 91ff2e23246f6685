//: Include what cells need
#include "untangle/cells.h"

#include <math.h>
#include <string.h>

//: Begin a grid
static tf_cell_box extent_of_all(const tf_neighbors *all, const double x[])
{
    tf_cell_box box = {.low = {0, 0, 0}};
    for (int v = 0; v < all->vertices; v++) {
        tf_vector place = tf_place(all, x, v);
        for (int k = 0; k < 3; k++) {
            box.low[k] = v > 0 ? fmin(box.low[k], place.x[k]) : place.x[k];
            box.high[k] = v > 0 ? fmax(box.high[k], place.x[k]) : place.x[k];
        }
    }
    return box;
}

/// Makes cells larger until there are not too many.
static void choose_size(tf_cells *cells, const tf_cell_box *box, int most)
{
    for (double all = INFINITY; all > most; cells->size *= 1.25) {
        all = 1;
        for (int k = 0; k < 3; k++)
            all *= floor((box->high[k] - box->low[k]) / cells->size) + 1;
    }
    for (int k = 0; k < 3; k++) {
        double way = box->high[k] - box->low[k];
        cells->low[k] = box->low[k];
        cells->count[k] = (int)(way / cells->size) + 1;
    }
}

/// Sums have one row more along each axis.
static size_t sums(const tf_cells *cells)
{
    size_t count = 1;
    for (int k = 0; k < 3; k++)
        count *= (size_t)cells->count[k] + 1;
    return count;
}

bool tf_cells_begin(tf_cells *cells, const tf_neighbors *all, const double x[],
                    double size, int most)
{
    tf_cell_box box = extent_of_all(all, x);
    cells->size = size;
    choose_size(cells, &box, most);
    if (!tf_buffer_reserve(&cells->storage, sums(cells), sizeof(int)))
        return false;
    cells->sum = cells->storage.data;
    memset(cells->sum, 0, sums(cells) * sizeof(int));
    return true;
}

void tf_cells_free(tf_cells *cells)
{
    tf_buffer_free(&cells->storage);
}

//: Find the cells of a box
/// From the first one to the one before the end, along each axis.
typedef struct range {
    int begin[3], end[3];
} range;

/// What is outside of the grid is in the cells at its rim.  Rounding keeps the
/// order of coordinates.
static int cell_of(const tf_cells *cells, int axis, double coordinate)
{
    double place = (coordinate - cells->low[axis]) / cells->size;
    double last = cells->count[axis] - 1;
    return (int)fmin(fmax(place, 0), last);
}

static range range_of(const tf_cells *cells, const tf_cell_box *box)
{
    range own;
    for (int k = 0; k < 3; k++) {
        own.begin[k] = cell_of(cells, k, box->low[k]);
        own.end[k] = cell_of(cells, k, box->high[k]) + 1;
    }
    return own;
}

//: Go through the corners of a range
/// A corner is at the end along axis k if bit k of its number is set; the
/// sign is that of inclusion and exclusion.
static int *corner_of(const tf_cells *cells, const range *own, int corner,
                      int *sign)
{
    size_t place = 0;
    *sign = 1;
    for (int k = 0; k < 3; k++) {
        bool is_end = (corner >> k & 1) != 0;
        int at = is_end ? own->end[k] : own->begin[k];
        place = place * ((size_t)cells->count[k] + 1) + (size_t)at;
        *sign = is_end ? -*sign : *sign;
    }
    return cells->sum + place;
}

void tf_cells_add(tf_cells *cells, const tf_cell_box *box)
{
    range own = range_of(cells, box);
    for (int corner = 0; corner < 8; corner++) {
        int sign = 1, *sum = corner_of(cells, &own, corner, &sign);
        *sum += sign;
    }
}

//: Sum over cells
/// Along each axis, from the first cell to each.
static void add_up(tf_cells *cells)
{
    size_t step = 1;
    for (int k = 2; k >= 0; k--) {
        size_t row = step * ((size_t)cells->count[k] + 1);
        for (size_t begin = 0; begin < sums(cells); begin += row)
            for (size_t i = begin + step; i < begin + row; i++)
                cells->sum[i] += cells->sum[i - step];
        step = row;
    }
}

/// First of what the boxes have left at their corners; then each cell has as
/// many as reach it.  A second time of cells with a box, each moved on by one,
/// so that the sum at the beginning of a range is of what is before it.
void tf_cells_sum(tf_cells *cells)
{
    size_t row = (size_t)cells->count[2] + 1;
    size_t shift = ((size_t)cells->count[1] + 1) * row + row + 1;
    size_t count = sums(cells);
    add_up(cells);
    for (size_t i = count; i-- > 0;)
        cells->sum[i] = i >= shift && cells->sum[i - shift] > 0;
    add_up(cells);
}

//: Ask cells
static int count_filled(const tf_cells *cells, const range *own)
{
    int count = 0;
    for (int corner = 0; corner < 8; corner++) {
        int sign = 1, *sum = corner_of(cells, own, corner, &sign);
        count -= sign * *sum;
    }
    return count;
}

bool tf_cells_touch(const tf_cells *cells, const tf_cell_box *box)
{
    range own = range_of(cells, box);
    return count_filled(cells, &own) > 0;
}

bool tf_cells_cover(const tf_cells *cells, const tf_cell_box *box)
{
    range own = range_of(cells, box);
    int count = 1;
    for (int k = 0; k < 3; k++)
        count *= own.end[k] - own.begin[k];
    return count_filled(cells, &own) == count;
}
