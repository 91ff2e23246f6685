//: Declare streams that compress
#pragma once

#include <stdbool.h>
#include <stdio.h>

/// Whether the name of a file says that it is compressed: it ends in .gz, in
/// small or capital letters.
bool tf_is_gzip_name(const char *path);

/// Opens a stream that writes what it is given to another one, compressed by
/// gzip, the same bytes each time.  Close it first, and write nothing to the
/// other one.  NULL, with errno, if that fails.
FILE *tf_gzip_open(FILE *to);
