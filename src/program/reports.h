//: Declare the reports of changes
#pragma once

#include "files/record.h"
#include "remesh/remesh.h"
#include "response/options.h"
#include "scenes/untangled_frame.h"
#include "scenes/weld.h"
#include "surgery/defects.h"

/// What it took to resolve a step.
typedef struct tf_resolved {
    const char *status; ///< "clear" or "resolved"
    tf_response_report report;
    double seconds;
    int exempt_zones;        ///< of what crosses at the start, and is left out
    size_t exempt_crossings; ///< intersections in them
} tf_resolved;

/// What it took to remesh a surface.
typedef struct tf_remeshed {
    tf_remesh_report report;
    int triangles_before, triangles_after;
    double edge; ///< the length that was wanted
    double seconds;
    int turned, left_alone;                    ///< triangles
    int edges, vertices, collinear, crossings; ///< defects
} tf_remeshed;

/// Sets what was wrong with the surface.
void tf_remeshed_set_defects(tf_remeshed *remeshed, const tf_defects *defects);

/// What it took to untangle a surface.
typedef struct tf_untangled {
    const char *status;     ///< "clear", "untangled" or "tangled"
    const char *rung_names; ///< `rungs`, or "none"
    char rungs[48];         ///< that moved something
    size_t before, left;    ///< intersections, with polygons divided where
                            ///< their corners were and are
    tf_untangle_report report;
    double seconds;
} tf_untangled;

/// Sets what was done; the names of the rungs stay where it is.
void tf_untangled_set(tf_untangled *untangled, const tf_untangled_frame *done,
                      double seconds);

/// Their fields, and those of a tf_weld_report.
extern const tf_field tf_resolved_fields[], tf_remeshed_fields[],
    tf_weld_fields[], tf_untangled_fields[];
