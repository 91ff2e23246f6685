//: Declare the output of a mesh with a report
#pragma once

#include "files/record.h"
#include "formats/mesh_writer.h"
#include "program/destination.h"

/// A report, which is a record.
typedef struct tf_mesh_report {
    tf_format format;
    const tf_field *field;
    const void *record;
} tf_mesh_report;

/// Writes a mesh, in the format that the name of the file suggests or else in
/// the usual one, and a report of how it was made to standard output; or, if
/// that has the mesh, to standard error.  False: there is a fault.
bool tf_mesh_output_write(tf_destination *to, const tf_mesh_content *content,
                          tf_mesh_format usual, const tf_mesh_report *report);
