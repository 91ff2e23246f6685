//: Include what the table of steps needs
#define _POSIX_C_SOURCE 200809L
#include "program/steps_file.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

//: Begin the table of steps
static const char heading[] =
    "step,time,first_contacts,contacts,impulse_rounds,zone_rounds,rigid_rounds,"
    "failsafe_rounds,rows,held,grouped,resting,stretch,kinetic_energy,"
    "elastic_energy,dynamics_seconds,response_seconds\n";

FILE *tf_steps_file_begin(const char *path)
{
    FILE *table = fopen(path, "w");
    if (table && (fputs(heading, table) < 0 || fflush(table) != 0)) {
        int cause = errno;
        fclose(table);
        errno = cause;
        return NULL;
    }
    return table;
}

//: Go on with a table of steps
/// Reads a line up to its end; false if it does not begin with these words.
static bool skip_line(FILE *table, const char *words)
{
    for (const char *c = words; *c; c++)
        if (getc(table) != *c)
            return false;
    int c = (unsigned char)words[strlen(words) - 1];
    while (c != '\n' && c != EOF)
        c = getc(table);
    return c == '\n';
}

static bool skip_lines(FILE *table, int steps)
{
    bool good = skip_line(table, heading);
    for (int i = 1; i <= steps && good; i++) {
        char number[16];
        snprintf(number, sizeof number, "%d,", i);
        good = skip_line(table, number);
    }
    return good;
}

FILE *tf_steps_file_resume(const char *path, int steps)
{
    FILE *table = fopen(path, "r+");
    if (!table)
        return NULL;
    errno = 0;
    long end = skip_lines(table, steps) ? ftell(table) : -1;
    if (end >= 0 && fseek(table, end, SEEK_SET) == 0 &&
        ftruncate(fileno(table), end) == 0)
        return table;
    int cause = errno;
    fclose(table);
    errno = cause;
    return NULL;
}

//: Add a line to the table of steps
static void write_report(FILE *table, const tf_response_report *report)
{
    fprintf(table, ",%zu,%zu", report->first_contacts, report->contacts);
    for (int i = 0; i < TF_LEVELS; i++)
        fprintf(table, ",%d", report->rounds[i]);
    fprintf(table, ",%zu,%d,%d,%d", report->rows, report->held, report->grouped,
            report->resting);
}

bool tf_steps_file_add(FILE *table, const tf_simulation *simulation,
                       const tf_step_cost *cost)
{
    const tf_simulation *s = simulation;
    const tf_body *body = &s->stage.body;
    fprintf(table, "%d,%.6g", s->step, s->step * s->scene->step);
    write_report(table, &cost->report);
    fprintf(table, ",%.6f,%.6g,%.6g,%.6f,%.6f\n",
            tf_body_stretch(body, s->position),
            tf_body_kinetic_energy(body, s->velocity),
            tf_body_elastic_energy(body, s->position), cost->dynamics,
            cost->response);
    return fflush(table) == 0 && !ferror(table);
}
