//: Declare the output of a mesh with a report
#pragma once

#include "files/mesh_file.h"
#include "files/output_file.h"

#include <stdbool.h>
#include <stdio.h>

/// A mesh that is written to a file, and a report of how it was made, to
/// standard output; or, if the file is "-", the mesh to standard output, and the
/// report to standard error.
typedef struct tf_mesh_output {
    const char *path;
    tf_output_file file;
    const char *target; ///< what could not be written, or NULL
    int error;          ///< its errno
} tf_mesh_output;

/// Finds out early whether the file can be written.  Borrows the path.  False:
/// there is an error.
bool tf_mesh_output_begin(tf_mesh_output *output, const char *path);

/// Writes the mesh, in the format that the name of the file suggests or else the
/// mesh has, and the report, by `report`, which returns false, with errno, if a
/// write failed.  The file appears whole or not at all.
bool tf_mesh_output_write(tf_mesh_output *output, const tf_mesh_file *mesh,
                          bool (*report)(FILE *stream, const void *context),
                          const void *context);

/// Prints the error, if there is one, and removes what is not finished.
void tf_mesh_output_end(tf_mesh_output *output);
