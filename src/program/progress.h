//: Declare the progress line and its clock
#pragma once

#include "base/progress.h"

#include <stdbool.h>

/// A line on the terminal about work that takes more than a second, written
/// over five times a second and erased at the end.  Shown only if standard
/// error is a terminal, and it would not garble standard output.
typedef struct tf_progress_line {
    bool wanted, shown;
    double next; ///< when to show it again, in seconds
} tf_progress_line;

/// @param silent nothing is printed on standard output until the end
tf_progress_line tf_progress_line_begin(bool silent);
void tf_progress_line_show(tf_progress_line *progress, long count,
                           const char *things);

/// The same for a long call of the library, whose context is a line.
bool tf_progress_line_show_stage(void *progress, const tf_stage *stage);

void tf_progress_line_end(tf_progress_line *progress);

/// Seconds since some time in the past, which never jump.
double tf_clock_seconds(void);
