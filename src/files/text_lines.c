//: Include what the lines of a text need
#define _GNU_SOURCE
#include "files/text_lines.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

//: Open and close a text
void tf_text_lines_start(tf_text_lines *lines, FILE *stream, const char *name,
                         tf_fault *fault)
{
    *lines = (tf_text_lines){.text = {.name = name, .fault = fault},
                             .stream = stream};
}

bool tf_text_lines_open(tf_text_lines *lines, const char *path, tf_fault *fault)
{
    bool standard = strcmp(path, "-") == 0;
    const char *name = standard ? "standard input" : path;
    FILE *stream = standard ? stdin : fopen(path, "r");
    tf_text_lines_start(lines, stream, name, fault);
    return stream || tf_fault_set_unopened(fault, name, errno);
}

void tf_text_lines_close(tf_text_lines *lines)
{
    if (lines->stream && lines->stream != stdin)
        fclose(lines->stream);
    free(lines->row);
    *lines = (tf_text_lines){0};
}

//: Take the ends off a line
static bool clean_line(tf_text_lines *lines, size_t length)
{
    tf_text *text = &lines->text;
    char *row = lines->row;
    if (strlen(row) != length)
        return tf_text_fault_in_nul(text);
    if (length > 0 && row[length - 1] == '\n')
        row[--length] = '\0';
    if (length > 0 && row[length - 1] == '\r')
        row[--length] = '\0';
    bool marked = text->line == 1 && strncmp(row, "\xEF\xBB\xBF", 3) == 0;
    text->at = row + (marked ? 3 : 0);
    return true;
}

//: Read a line
static tf_reading read_line(tf_text_lines *lines)
{
    tf_text *text = &lines->text;
    errno = 0;
    ssize_t length = getline(&lines->row, &lines->room, lines->stream);
    if (length < 0 && feof(lines->stream) && !ferror(lines->stream))
        return TF_READ_END;
    text->line++;
    bool good = length < 0 ? tf_fault_set_unread(text->fault, text->name,
                                                 text->line, errno)
                           : clean_line(lines, (size_t)length);
    return good ? TF_READ_GOOD : TF_READ_FAULT;
}

//: Read the next line that holds something
tf_reading tf_text_lines_next(tf_text_lines *lines)
{
    tf_text *text = &lines->text;
    tf_reading reading;
    do {
        reading = read_line(lines);
        if (reading == TF_READ_GOOD)
            tf_text_skip_blanks(text);
    } while (reading == TF_READ_GOOD &&
             (*text->at == '\0' || *text->at == '#'));
    return reading;
}
