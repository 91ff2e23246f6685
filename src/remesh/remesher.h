//: Hold a remeshing
#pragma once

#include "base/status.h"
#include "remesh/options.h"
#include "remesh/original.h"
#include "remesh/trace.h"
#include "surface/sort.h"

/// How to remesh: see remesh/policy.h.
typedef struct tf_remesh_policy tf_remesh_policy;

/// A surface that is being remeshed.
typedef struct tf_remesher {
    tf_adaptive_surface *surface; ///< with the watch over the call
    const tf_remesh_policy *policy;
    double edge;                 ///< the target length, or the greatest one
    const double *target;        ///< the target length at each vertex of the
                                 ///< original; NULL: `edge` everywhere
    tf_original original;        ///< empty unless the policy needs one
    tf_projection projection;    ///< to it, the last one
    tf_sharp_edges sharp;        ///< of the surface, by now
    tf_sharp_edges sharp_before; ///< of the original
    tf_trace trace;              ///< to it
    tf_buffer corner_origin;     ///< tf_origin of each corner, at the end
    tf_remesh_report report;
    size_t restored[TF_OUTCOMES]; ///< moves that were to restore volume
    tf_buffer map;                ///< of vertices, when gaps are closed
    tf_buffer row;                ///< tf_edge_row each
    int rows;
    tf_sort_memory sorting; ///< of the rows
} tf_remesher;

void tf_remesher_free(tf_remesher *remesher);

/// In bytes, without the original and the trace.
size_t tf_remesher_memory(const tf_remesher *remesher);

/// Closes the gaps of the surface, and of what is known of its vertices.  Returns
/// TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED.
tf_status tf_remesher_compact(tf_remesher *remesher);

/// Counts what became of an operation.
void tf_remesher_count(tf_remesher *remesher, tf_operation operation,
                       tf_outcome outcome);

//: Declare target lengths
/// The length that edges at a vertex should have: between those of the original
/// where the vertex comes from.
double tf_target_at(const tf_remesher *remesher, int vertex);

/// The mean of two, for the edge between them.
double tf_target_between(const tf_remesher *remesher, int a, int b);

//: Declare how edges are visited
/// An edge to be visited: its length when it was listed, as a multiple of the
/// target length, and its ends.
typedef struct tf_edge_row {
    double ratio;
    int a, b;
} tf_edge_row;

/// In which order edges are visited.
typedef enum tf_edge_order {
    TF_SHORTEST_FIRST,
    TF_LONGEST_FIRST
} tf_edge_order;

/// A pass over edges.
typedef struct tf_edge_pass {
    const char *name; ///< the name of its stage
    tf_edge_order order;
    tf_status (*visit)(tf_remesher *remesher, const tf_edge_row *edge);
} tf_edge_pass;

/// Lists the edges whose ratio is at least `low` and at most `high`, and then
/// visits them, until a visit returns something other than TF_OK.  Returns
/// that, or TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED.
tf_status tf_remesher_visit(tf_remesher *remesher, const tf_edge_pass *pass,
                            double low, double high);
