//: Declare destinations
#pragma once

#include "files/fault.h"
#include "files/output_file.h"

/// Where a command writes: a file, or standard output if its name is "-".  The
/// file appears whole or not at all, and is compressed if its name ends in .gz.
typedef struct tf_destination {
    const char *path;
    FILE *stream; ///< NULL: not open
    FILE *plain;  ///< where the stream writes to, compressed; or NULL
    tf_output_file file;
    tf_fault *fault; ///< to be set
} tf_destination;

/// Whether a name is that of standard output.
bool tf_destination_is_standard(const char *path);

/// Finds out early whether it can be written.  Borrows the name and the fault.
/// This and all below are false, or NULL, after an error, which is in the fault.
bool tf_destination_begin(tf_destination *to, const char *path,
                          tf_fault *fault);

/// The stream to write to.
FILE *tf_destination_open(tf_destination *to);

/// All that was written is out, and of a file on the disk.
bool tf_destination_close(tf_destination *to);

/// Lets the file appear.
bool tf_destination_keep(tf_destination *to);

/// Closes and keeps it if all is good and no write has failed before, for a
/// reason of errno.
bool tf_destination_finish(tf_destination *to, bool good, int reason);

/// Removes what was not kept.
void tf_destination_end(tf_destination *to);
