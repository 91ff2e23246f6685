//: Declare output files
#pragma once

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

/// A file in the making.  What is there already, and is no ordinary file but a
/// pipe or a device, for instance, is written to directly.
typedef struct tf_output_file {
    char *path;    ///< that of the file; a symbolic link is followed
    char *scratch; ///< what to write to: in the folder of `path`, with its
                   ///< ending, or `path` itself; NULL after a failure
    int lock;      ///< a descriptor that holds the scratch file; -1: none does
} tf_output_file;

/// Makes an empty scratch file.  False, with errno, if that fails.  A signal
/// that ends the program removes it; if none can, as after SIGKILL, the next
/// program that begins or clears the same file does.
bool tf_output_file_begin(tf_output_file *file, const char *path);

/// Gives the scratch file its name, over what has it now.  False, with errno,
/// if that fails; then the scratch file is gone.
bool tf_output_file_keep(tf_output_file *file);

/// Removes the scratch file, if there is one.
void tf_output_file_drop(tf_output_file *file);

/// Removes the scratch files of a file that killed programs have left.  Those of
/// programs that live, and all other files, stay.
void tf_output_file_clear(const char *path);

/// Names the child process that writes to a scratch file; 0: none does.  A
/// signal that ends the program ends it first, lest it make the file again.
void tf_output_file_writer(pid_t process);

//: Declare how to write to an output file
/// Opens the scratch file; NULL, with errno, if that fails.
FILE *tf_output_file_open(const tf_output_file *file);

/// Closes a stream that was opened so, once all bytes are on the disk.  False,
/// with errno, if that fails, or if a write did before.
bool tf_output_file_close(const tf_output_file *file, FILE *stream);
