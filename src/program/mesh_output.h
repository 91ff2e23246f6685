//: Declare the output of a mesh with a report
#pragma once

#include "files/mesh_writer.h"
#include "files/output_file.h"
#include "files/record.h"

/// A mesh that is written to a file, and a report of how it was made, to
/// standard output; or, if the file is "-", the mesh to standard output, and the
/// report to standard error.
typedef struct tf_mesh_output {
    const char *path;
    tf_fault *fault; ///< to be set
    tf_output_file file;
} tf_mesh_output;

/// A report, which is a record.
typedef struct tf_mesh_report {
    tf_format format;
    const tf_field *field;
    const void *record;
} tf_mesh_report;

/// Finds out early whether the file can be written.  Borrows the path and the
/// fault.  False: there is one.
bool tf_mesh_output_begin(tf_mesh_output *output, const char *path,
                          tf_fault *fault);

/// Writes the mesh, in the format that the name of the file suggests or else in
/// the usual one, and the report.  The file appears whole or not at all.
bool tf_mesh_output_write(tf_mesh_output *output,
                          const tf_mesh_content *content, tf_mesh_format usual,
                          const tf_mesh_report *report);

/// Removes what is not finished.
void tf_mesh_output_end(tf_mesh_output *output);
