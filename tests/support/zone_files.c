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
    fprintf(file, "zone %d %d %d\n", axes, zone->vertices, zone->constraints);
    for (int v = 0; v < zone->vertices; v++) {
        fprintf(file, "%.6g", zone->inverse_mass[v]);
        write_numbers(file, axes, zone->displacement + axes * v);
        fputc('\n', file);
    }
    for (int i = 0; i < zone->constraints; i++) {
        const tf_constraint *constraint = &zone->constraint[i];
        fprintf(file, "%d %d %d %d", constraint->vertex[0],
                constraint->vertex[1], constraint->vertex[2],
                constraint->vertex[3]);
        write_numbers(file, 4, constraint->coefficient);
        write_numbers(file, axes, constraint->normal);
        write_numbers(file, 1, &constraint->bound);
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

static void read_constraint(FILE *file, int axes, tf_constraint *constraint)
{
    for (int i = 0; i < 4; i++)
        if (fscanf(file, "%d", &constraint->vertex[i]) != 1)
            abort();
    read_numbers(file, 4, constraint->coefficient);
    read_numbers(file, axes, constraint->normal);
    read_numbers(file, 1, &constraint->bound);
}

bool zone_read(FILE *file, double more, zone_case *read)
{
    int axes, vertices, constraints;
    int found = fscanf(file, " zone %d %d %d", &axes, &vertices, &constraints);
    if (found == EOF)
        return false;
    if (found != 3 || axes < 2 || axes > 3 || vertices < 1 || constraints < 1)
        abort();
    *read =
        zone_new(axes, vertices, constraints + (int)(more * constraints) + 1);
    read->zone.constraints = constraints;
    for (int v = 0; v < vertices; v++) {
        read_numbers(file, 1, &read->inverse_mass[v]);
        read_numbers(file, axes, read->proposal + axes * v);
    }
    for (int i = 0; i < constraints; i++)
        read_constraint(file, axes, &read->constraint[i]);
    return true;
}
