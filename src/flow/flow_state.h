//: Hold a flow
#pragma once

#include "flow/flow.h"
#include "remesh/remesher.h"

/// A surface that makes a step of a flow.
typedef struct tf_flow_state {
    tf_remesher remesher; ///< what lists edges and counts operations
    const tf_flow_options *options;
    tf_flow_report *report;
} tf_flow_state;

/// Whether an operation, or for TF_OPERATIONS the advance, keeps the volume.
bool tf_flow_keeps_volume(const tf_flow_state *flow, tf_operation operation);

//: Declare the passes of a flow
/// Each goes once through the surface, and returns TF_OK or what went wrong.
tf_status tf_refine_pass(tf_flow_state *flow);
tf_status tf_turn_pass(tf_flow_state *flow);
tf_status tf_coarsen_pass(tf_flow_state *flow);
tf_status tf_relax_pass(tf_flow_state *flow);

/// Moves all vertices along the velocity.
tf_status tf_advect(tf_flow_state *flow, double time, double step);

//: Declare how volume is given back
/// Moves vertices along their normals, one after the other, such that in all 1/6
/// of `more` is gained; less if a move is refused.
tf_status tf_flow_restore_volume(tf_flow_state *flow, double more, int count,
                                 const int vertex[]);
