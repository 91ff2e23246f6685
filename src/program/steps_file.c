//: Include what the table of steps needs
#define _POSIX_C_SOURCE 200809L
#include "program/steps_file.h"

#include <errno.h>
#include <unistd.h>

//: Begin the table of steps
/// The columns that all tables begin with.
static const char first_columns[] = "step,time,";

FILE *tf_steps_file_begin(const char *path, const tf_simulated_kind *kind)
{
    FILE *table = fopen(path, "w");
    if (table && (fprintf(table, "%s%s\n", first_columns, kind->columns) < 0 ||
                  fflush(table) != 0)) {
        int cause = errno;
        fclose(table);
        errno = cause;
        return NULL;
    }
    return table;
}

//: Go on with a table of steps
static bool skip_words(FILE *table, const char *words)
{
    for (const char *c = words; *c; c++)
        if (getc(table) != *c)
            return false;
    return true;
}

/// Reads a line up to its end; false if it does not begin with a number.
static bool skip_line(FILE *table, const char *number)
{
    int c = skip_words(table, number) ? ',' : EOF;
    while (c != '\n' && c != EOF)
        c = getc(table);
    return c == '\n';
}

static bool skip_lines(FILE *table, const tf_simulated_kind *kind, int steps)
{
    bool good = skip_words(table, first_columns) &&
                skip_words(table, kind->columns) && getc(table) == '\n';
    for (int i = 1; i <= steps && good; i++) {
        char number[16];
        snprintf(number, sizeof number, "%d,", i);
        good = skip_line(table, number);
    }
    return good;
}

FILE *tf_steps_file_resume(const char *path, const tf_simulated_kind *kind,
                           int steps)
{
    FILE *table = fopen(path, "r+");
    if (!table)
        return NULL;
    errno = 0;
    long end = skip_lines(table, kind, steps) ? ftell(table) : -1;
    if (end >= 0 && fseek(table, end, SEEK_SET) == 0 &&
        ftruncate(fileno(table), end) == 0)
        return table;
    int cause = errno;
    fclose(table);
    errno = cause;
    return NULL;
}

//: Add a line to the table of steps
bool tf_steps_file_add(FILE *table, const tf_simulated *simulated)
{
    fprintf(table, "%d,%.6g", simulated->step,
            simulated->step * simulated->length);
    simulated->kind->write_line(table, simulated);
    putc('\n', table);
    return fflush(table) == 0 && !ferror(table);
}
