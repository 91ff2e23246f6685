//: Include what the lines of a text need
#define _GNU_SOURCE
#include "files/text_lines.h"

#include "files/visible.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

//: Open and close a text
void tf_text_lines_start(tf_text_lines *lines, FILE *stream, const char *name)
{
    *lines = (tf_text_lines){.name = name, .stream = stream};
}

bool tf_text_lines_open(tf_text_lines *lines, const char *path)
{
    bool standard = strcmp(path, "-") == 0;
    FILE *stream = standard ? stdin : fopen(path, "r");
    tf_text_lines_start(lines, stream, standard ? "standard input" : path);
    return stream ||
           tf_text_lines_fault(lines, 0, "cannot open: %s; check the name",
                               strerror(errno));
}

void tf_text_lines_close(tf_text_lines *lines)
{
    if (lines->stream && lines->stream != stdin)
        fclose(lines->stream);
    free(lines->row);
    *lines = (tf_text_lines){0};
}

//: Describe what is wrong with a text
bool tf_text_lines_fault(tf_text_lines *lines, long line, const char *format,
                         ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(lines->fault, sizeof lines->fault, format, arguments);
    va_end(arguments);
    lines->fault_line = line;
    return false;
}

void tf_text_lines_print_fault(const tf_text_lines *lines, const char *program)
{
    fprintf(stderr, "%s: %s:", program, tf_make_visible(lines->name).text);
    if (lines->fault_line > 0)
        fprintf(stderr, "%ld:", lines->fault_line);
    fprintf(stderr, " %s\n", lines->fault);
}

//: Take the ends off a line
static bool clean_line(tf_text_lines *lines, size_t length)
{
    if (strlen(lines->row) != length)
        return tf_text_lines_fault(lines, lines->line,
                                   "a NUL byte; the file must be plain text "
                                   "(ASCII or UTF-8, not UTF-16 or binary)");
    if (length > 0 && lines->row[length - 1] == '\n')
        lines->row[--length] = '\0';
    if (length > 0 && lines->row[length - 1] == '\r')
        lines->row[--length] = '\0';
    bool marked =
        lines->line == 1 && strncmp(lines->row, "\xEF\xBB\xBF", 3) == 0;
    lines->at = lines->row + (marked ? 3 : 0);
    return true;
}

//: Read a line
static tf_reading read_line(tf_text_lines *lines)
{
    errno = 0;
    ssize_t length = getline(&lines->row, &lines->room, lines->stream);
    if (length < 0 && feof(lines->stream) && !ferror(lines->stream))
        return TF_READ_END;
    lines->line++;
    if (length < 0) {
        tf_text_lines_fault(lines, lines->line,
                            "cannot read: %s; check that this is a file",
                            strerror(errno));
        return TF_READ_FAULT;
    }
    return clean_line(lines, (size_t)length) ? TF_READ_GOOD : TF_READ_FAULT;
}

//: Read the next line that holds something
void tf_text_lines_skip_blanks(tf_text_lines *lines)
{
    while (*lines->at == ' ' || *lines->at == '\t')
        lines->at++;
}

tf_reading tf_text_lines_next(tf_text_lines *lines)
{
    tf_reading reading;
    do {
        reading = read_line(lines);
        if (reading == TF_READ_GOOD)
            tf_text_lines_skip_blanks(lines);
    } while (reading == TF_READ_GOOD &&
             (*lines->at == '\0' || *lines->at == '#'));
    return reading;
}
