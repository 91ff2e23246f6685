//: Include what the table of steps needs
#define _POSIX_C_SOURCE 200809L
#include "program/steps_file.h"

#include "program/step_columns.h"

#include <errno.h>
#include <unistd.h>

//: Begin the table of steps
static bool write_heading(FILE *table, const tf_simulation_kind *kind)
{
    fputs("step,time", table);
    for (const tf_step_column *c = tf_step_columns(kind); c->type; c++)
        if (c->name)
            fprintf(table, ",%s", c->name);
    putc('\n', table);
    return fflush(table) == 0 && !ferror(table);
}

/// Closes a table after an error.  Returns NULL.
static FILE *give_up(FILE *table)
{
    int cause = errno;
    fclose(table);
    errno = cause;
    return NULL;
}

FILE *tf_steps_file_begin(const char *path, const tf_simulation_kind *kind)
{
    FILE *table = fopen(path, "w");
    return table && !write_heading(table, kind) ? give_up(table) : table;
}

//: Go on with a table of steps
static bool skip_words(FILE *table, const char *words)
{
    for (const char *c = words; *c; c++)
        if (getc(table) != *c)
            return false;
    return true;
}

static bool skip_heading(FILE *table, const tf_simulation_kind *kind)
{
    bool good = skip_words(table, "step,time");
    for (const tf_step_column *c = tf_step_columns(kind); c->type && good; c++)
        good =
            !c->name || (skip_words(table, ",") && skip_words(table, c->name));
    return good && skip_words(table, "\n");
}

/// Reads a line up to its end; false if it does not begin with a number.
static bool skip_line(FILE *table, int step)
{
    char number[16];
    snprintf(number, sizeof number, "%d,", step);
    int c = skip_words(table, number) ? ',' : EOF;
    while (c != '\n' && c != EOF)
        c = getc(table);
    return c == '\n';
}

FILE *tf_steps_file_resume(const char *path, const tf_simulation_kind *kind,
                           int steps)
{
    FILE *table = fopen(path, "r+");
    if (!table)
        return NULL;
    errno = 0;
    bool good = skip_heading(table, kind);
    for (int i = 1; i <= steps && good; i++)
        good = skip_line(table, i);
    long end = good ? ftell(table) : -1;
    return end >= 0 && fseek(table, end, SEEK_SET) == 0 &&
                   ftruncate(fileno(table), end) == 0
               ? table
               : give_up(table);
}

//: Add a line to the table of steps
bool tf_steps_file_add(FILE *table, const tf_simulation *simulation)
{
    const tf_scene *scene = simulation->scene;
    fprintf(table, "%d,%.6g", simulation->step, simulation->step * scene->step);
    for (const tf_step_column *c = tf_step_columns(scene->kind); c->type; c++)
        if (c->name) {
            putc(',', table);
            fprintf(table, c->format, tf_step_number(c, simulation));
        }
    putc('\n', table);
    return fflush(table) == 0 && !ferror(table);
}
