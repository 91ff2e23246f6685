//: Declare the output of a mesh with a report
#pragma once

#include "files/destination.h"
#include "files/record.h"
#include "writers/mesh_writer.h"

/// A report, which is a record.
typedef struct tf_mesh_report {
    tf_format format;
    const tf_field *field;
    const void *record;
} tf_mesh_report;

/// Finds out early whether a mesh made of a file can be written to a path, in the
/// format that the name suggests or else in that of the file, and begins a
/// destination.  False: there is a fault.
bool tf_mesh_output_begin(tf_destination *to, const char *path,
                          const tf_mesh_file *made_of, tf_fault *fault);

/// Says on standard error what writing a mesh made of a file to that path does
/// not keep of the file, if that has a source, and once whether it rounds
/// positions.
void tf_mesh_output_remark(const char *path, const tf_mesh_content *content,
                           const tf_mesh_file *made_of);

/// Writes a mesh made of a file, without what its faces have if the format does
/// not hold that, in that format, and a report of how it was made
/// to standard output; or, if that has the mesh, to standard error.  Remarks on
/// it.  False: there is a fault.
bool tf_mesh_output_write(tf_destination *to, const tf_mesh_content *content,
                          const tf_mesh_file *made_of,
                          const tf_mesh_report *report);
