// Files that appear whole or not at all.
#ifndef FIG_DRAW_OUTPUT_FILE_H
#define FIG_DRAW_OUTPUT_FILE_H

#include <stdbool.h>
#include <sys/types.h>

/// A file in the making: `scratch`, in the folder of `path` and with its
/// ending, becomes the file when it is kept.
typedef struct fig_output_file {
    const char *path; ///< borrowed
    char *scratch;    ///< there to be opened and written; NULL after a failure
} fig_output_file;

/// Make an empty scratch file.  False, with errno, if that fails.  A signal
/// that ends the program removes it.
bool fig_output_file_begin(fig_output_file *file, const char *path);

/// Give the scratch file its name, over what has it now.  False, with errno,
/// if that fails; then the scratch file is gone.
bool fig_output_file_keep(fig_output_file *file);

/// Remove the scratch file, if there is one.
void fig_output_file_drop(fig_output_file *file);

/// Name the child process that writes to a scratch file; 0: none does.  A
/// signal that ends the program ends it first, lest it make the file again.
void fig_output_file_writer(pid_t process);

#endif
