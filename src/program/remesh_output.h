//: Declare the report of remeshing
#pragma once

#include "files/record.h"
#include "remesh/remesh.h"

/// A report, and what else there is to say.
typedef struct tf_remeshed {
    tf_remesh_report report;
    int triangles_before, triangles_after;
    double edge; ///< the length that was wanted
    double seconds;
} tf_remeshed;

/// Writes it and flushes.  False, with errno, if a write failed.
bool tf_remesh_output_write(FILE *stream, tf_format format,
                            const tf_remeshed *remeshed);
