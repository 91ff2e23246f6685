//: Include what the table of steps needs
#define _POSIX_C_SOURCE 200809L
#include "program/steps_file.h"

#include "program/step_fields.h"

#include <errno.h>
#include <unistd.h>

//: Begin the table of steps
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
    if (table)
        tf_record_write_head(table, tf_step_columns(kind));
    return table && (fflush(table) != 0 || ferror(table)) ? give_up(table)
                                                          : table;
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
    bool good = true;
    for (const tf_field *c = tf_step_columns(kind); c->name && good; c++)
        good = skip_words(table, c->name) &&
               skip_words(table, c[1].name ? "," : "\n");
    return good;
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
    tf_record_write_csv(table, tf_step_columns(simulation->scene->kind),
                        simulation);
    return fflush(table) == 0 && !ferror(table);
}
