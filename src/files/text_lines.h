//: Declare the lines of a text
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum {
    TF_LINE_FAULT_LENGTH = 256
};

/// A text that is read line by line, in memory of the size of the longest line.
typedef struct tf_text_lines {
    const char *name; ///< for messages
    FILE *stream;
    long line; ///< the line read last
    char *row; ///< its text
    size_t room;
    const char *at;                   ///< how far it was read
    long fault_line;                  ///< 0: the fault is not in a line
    char fault[TF_LINE_FAULT_LENGTH]; ///< what is wrong; how to mend it
} tf_text_lines;

//: Declare how to read lines
typedef enum tf_reading {
    TF_READ_FAULT = 0, ///< bad input, described by `fault` and `fault_line`
    TF_READ_GOOD,
    TF_READ_END, ///< nothing is left, and all before was good
} tf_reading;

/// Starts to read a stream, or the file at `path` ("-": standard input).  Both
/// borrow the name.  Close the lines in any case, also if the file cannot be
/// opened; this closes the stream, too, unless it is standard input.
void tf_text_lines_start(tf_text_lines *lines, FILE *stream, const char *name);
bool tf_text_lines_open(tf_text_lines *lines, const char *path);
void tf_text_lines_close(tf_text_lines *lines);

/// Reads up to the next line that neither is blank nor begins with #, and steps
/// over the blanks that it begins with.
tf_reading tf_text_lines_next(tf_text_lines *lines);

/// Steps over blanks.
void tf_text_lines_skip_blanks(tf_text_lines *lines);

//: Declare the errors of a text
/// Sets the fault, as printf; false, for the caller to return.
__attribute__((format(printf, 3, 4))) bool
tf_text_lines_fault(tf_text_lines *lines, long line, const char *format, ...);

/// Prints the fault to standard error, with the names of program and file.
void tf_text_lines_print_fault(const tf_text_lines *lines, const char *program);
