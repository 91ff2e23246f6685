//: Declare columns of values
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum {
    TF_MOST_COLUMNS = 64,
    TF_COLUMN_NAME = 64 ///< bytes, with the zero at the end
};

/// The types of numbers in PLY.
typedef enum tf_number_type {
    TF_CHAR = 0,
    TF_UCHAR,
    TF_SHORT,
    TF_USHORT,
    TF_INT,
    TF_UINT,
    TF_FLOAT,
    TF_DOUBLE,
} tf_number_type;

/// What a column holds: a color, a texture coordinate, or any other number.
typedef struct tf_column {
    char name[TF_COLUMN_NAME];
    tf_number_type type;
    int after; ///< how many of x, y and z are before it in a file
} tf_column;

/// What the vertices of a mesh have besides positions: a row of numbers each.
/// All zero: there are no columns.
typedef struct tf_columns {
    int count;
    tf_column column[TF_MOST_COLUMNS];
    double *value; ///< `count` for each row
    size_t rows, room;
} tf_columns;

//: Declare how columns are filled
/// Frees the rows, and removes all columns.
void tf_columns_free(tf_columns *columns);

/// Adds a row.  False: there is no memory.
bool tf_columns_add(tf_columns *columns, const double value[]);

/// Adds a row that mixes those of three vertices with these weights; integers
/// are rounded.  The columns are the same.  False: there is no memory.
bool tf_columns_mix(tf_columns *columns, const tf_columns *from,
                    const int vertex[3], const double weight[3]);

/// The column of that name, or -1.
int tf_columns_find(const tf_columns *columns, const char *name);

/// The values of a row.
static inline const double *tf_columns_row(const tf_columns *columns, int row)
{
    return columns->value + (size_t)columns->count * (size_t)row;
}
