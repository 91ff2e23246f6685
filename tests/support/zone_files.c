#include "support/zone_files.h"

#include <stdlib.h>

// Writing ---------------------------------------------------------------------

static void write_numbers(FILE *file, int count, const double number[])
{
    for (int i = 0; i < count; i++)
        fprintf(file, " %.6g", number[i]);
}

void zone_write(FILE *file, const tf_zone *zone)
{
    int axes = zone->axes;
    fprintf(file, "zone %d %d %d\n", axes, zone->vertices, zone->rows);
    for (int v = 0; v < zone->vertices; v++) {
        fprintf(file, "%.6g", zone->inverse_mass[v]);
        write_numbers(file, axes, zone->displacement + axes * v);
        fputc('\n', file);
    }
    for (int i = 0; i < zone->rows; i++) {
        const tf_row *row = &zone->row[i];
        fprintf(file, "%d %d %d %d", row->vertex[0], row->vertex[1],
                row->vertex[2], row->vertex[3]);
        write_numbers(file, 4, row->coefficient);
        write_numbers(file, axes, row->normal);
        write_numbers(file, 1, &row->bound);
        fputc('\n', file);
    }
}

// Reading ---------------------------------------------------------------------

static void read_numbers(FILE *file, int count, double number[])
{
    for (int i = 0; i < count; i++)
        if (fscanf(file, "%lf", &number[i]) != 1)
            abort();
}

static void read_row(FILE *file, int axes, tf_row *row)
{
    for (int i = 0; i < 4; i++)
        if (fscanf(file, "%d", &row->vertex[i]) != 1)
            abort();
    read_numbers(file, 4, row->coefficient);
    read_numbers(file, axes, row->normal);
    read_numbers(file, 1, &row->bound);
}

bool zone_read(FILE *file, double more, zone_case *read)
{
    int axes, vertices, rows;
    int found = fscanf(file, " zone %d %d %d", &axes, &vertices, &rows);
    if (found == EOF)
        return false;
    if (found != 3 || axes < 2 || axes > 3 || vertices < 1 || rows < 1)
        abort();
    *read = zone_new(axes, vertices, rows + (int)(more * rows) + 1);
    read->zone.rows = rows;
    for (int v = 0; v < vertices; v++) {
        read_numbers(file, 1, &read->inverse_mass[v]);
        read_numbers(file, axes, read->proposal + axes * v);
    }
    for (int i = 0; i < rows; i++)
        read_row(file, axes, &read->row[i]);
    return true;
}
