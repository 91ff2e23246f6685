//: Declare the reports of changes
#pragma once

#include "files/record.h"
#include "remesh/remesh.h"
#include "response/options.h"
#include "scenes/weld.h"

/// What it took to resolve a step.
typedef struct tf_resolved {
    const char *status; ///< "clear" or "resolved"
    tf_response_report report;
    double seconds;
} tf_resolved;

/// What it took to remesh a surface.
typedef struct tf_remeshed {
    tf_remesh_report report;
    int triangles_before, triangles_after;
    double edge; ///< the length that was wanted
    double seconds;
} tf_remeshed;

/// Their fields, and those of a tf_weld_report.
extern const tf_field tf_resolved_fields[], tf_remeshed_fields[],
    tf_weld_fields[];
