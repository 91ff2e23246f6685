//: Declare the bytes of a file
#pragma once

#include "files/fault.h"

#include <stddef.h>

/// All bytes of a file, and a zero behind them.  All zero: there are none.
typedef struct tf_bytes {
    char *item;
    size_t count, room;
} tf_bytes;

/// Whether no more need be read, of what is already there; the last bytes are
/// new.
typedef bool tf_hopeless(const tf_bytes *bytes, size_t last);

/// Reads the file at `path` ("-": standard input), called `name` in faults; what
/// gzip has compressed is decompressed.  False: there is a fault.  Free the bytes
/// in any case.
bool tf_bytes_read(tf_bytes *bytes, const char *path, const char *name,
                   tf_hopeless *is_hopeless, tf_fault *fault);

void tf_bytes_free(tf_bytes *bytes);
