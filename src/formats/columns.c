//: Add rows
#include "formats/columns.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static bool make_room(tf_columns *columns)
{
    if (columns->rows < columns->room)
        return true;
    size_t room = 2 * columns->room + 64;
    size_t size = sizeof(double) * (size_t)(columns->count + 1);
    double *moved =
        room > SIZE_MAX / size ? NULL : realloc(columns->value, room * size);
    if (!moved)
        return false;
    columns->value = moved;
    columns->room = room;
    return true;
}

bool tf_columns_add(tf_columns *columns, const double value[])
{
    if (!make_room(columns))
        return false;
    size_t count = (size_t)columns->count;
    if (count > 0)
        memcpy(columns->value + count * columns->rows, value,
               count * sizeof *value);
    columns->rows++;
    return true;
}

void tf_columns_free(tf_columns *columns)
{
    free(columns->value);
    *columns = (tf_columns){0};
}

//: Mix rows
/// What has no weight does not count, even if it is no number.
static double mixed(const tf_columns *from, int column, const int vertex[3],
                    const double weight[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        if (weight[i] > 0)
            sum += weight[i] * tf_columns_row(from, vertex[i])[column];
    return from->column[column].type < TF_FLOAT ? floor(sum + 0.5) : sum;
}

bool tf_columns_mix(tf_columns *columns, const tf_columns *from,
                    const int vertex[3], const double weight[3])
{
    double value[TF_MOST_COLUMNS];
    for (int i = 0; i < from->count; i++)
        value[i] = mixed(from, i, vertex, weight);
    return tf_columns_add(columns, value);
}

//: Find a column
int tf_columns_find(const tf_columns *columns, const char *name)
{
    for (int i = 0; i < columns->count; i++)
        if (strcmp(columns->column[i].name, name) == 0)
            return i;
    return -1;
}
