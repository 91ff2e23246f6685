//: Declare the lines of a text
#pragma once

#include "files/text.h"

#include <stdio.h>

/// A text that is read line by line, in memory of the size of the longest line.
typedef struct tf_text_lines {
    tf_text text; ///< the line read last
    FILE *stream;
    char *row; ///< its memory
    size_t room;
} tf_text_lines;

//: Declare how to read lines
typedef enum tf_reading {
    TF_READ_FAULT = 0, ///< bad input, described by the fault
    TF_READ_GOOD,
    TF_READ_END, ///< nothing is left, and all before was good
} tf_reading;

/// Starts to read a stream, or the file at `path` ("-": standard input).  Both
/// borrow the name and the fault.  Close the lines in any case, also if the file
/// cannot be opened; this closes the stream, too, unless it is standard input.
void tf_text_lines_start(tf_text_lines *lines, FILE *stream, const char *name,
                         tf_fault *fault);
bool tf_text_lines_open(tf_text_lines *lines, const char *path,
                        tf_fault *fault);
void tf_text_lines_close(tf_text_lines *lines);

/// Reads up to the next line that neither is blank nor begins with #, and steps
/// over the blanks that it begins with.
tf_reading tf_text_lines_next(tf_text_lines *lines);
