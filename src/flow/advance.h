//: Declare advances
#pragma once

#include "flow/options.h"
#include "response/resolver.h"
#include "surface/buffer.h"
#include "surgery/adaptive.h"

/// An advance of all vertices of a surface at once.  Its points are the
/// vertices and, after them, the middles of the edges; each array has a vector
/// of each.
typedef struct tf_flow_advance {
    tf_adaptive_surface *surface;
    tf_surface *elements;  ///< of the surface in this step; NULL: none yet
    tf_resolver *resolver; ///< of these; NULL: none yet
    tf_buffer room;        ///< for the arrays below
    const tf_flow_options *options;
    double time, step;
    int vertices, edges, points;
    const int *edge;      ///< two vertices each
    double *start;        ///< where the points are
    double *stage;        ///< where a velocity is taken
    double *normal;       ///< there
    double *velocity;     ///< there
    double *end;          ///< where the points go
    double *inverse_mass; ///< of each vertex
} tf_flow_advance;

void tf_advance_free(tf_flow_advance *advance);
size_t tf_advance_memory(const tf_flow_advance *advance);

//: Declare the parts of an advance
/// Begins an advance of its surface, which has no gaps and is not empty.
/// Returns TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED.
tf_status tf_advance_begin(tf_flow_advance *advance,
                           const tf_flow_options *options, double time,
                           double step);

/// Finds the ends of all points, by the method of Runge and Kutta.  Returns TF_OK
/// or TF_CANCELLED.
tf_status tf_advance_propose(tf_flow_advance *advance);

/// Shifts the ends of the vertices along their normals, by a tenth of an edge
/// at most, so that the surface encloses as much as if its edges had curved
/// with their middles.  Returns TF_OK or TF_CANCELLED.
tf_status tf_advance_restore_volume(tf_flow_advance *advance);

/// Moves the vertices to their ends as far as the response lets them.  Returns
/// what tf_step_resolve does, and lends its report.
tf_status tf_advance_resolve(tf_flow_advance *advance,
                             const tf_response_report **report);
