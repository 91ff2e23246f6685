//: Hold a flow
#pragma once

#include "flow/flow.h"
#include "remesh/remesher.h"

/// A surface that makes a step of a flow.
typedef struct tf_flowing {
    tf_remesher remesher; ///< what lists edges and counts operations
    const tf_flow_options *options;
    tf_flow_report *report;
} tf_flowing;

/// Whether an operation, or for TF_OPERATIONS the advance, keeps the volume.
bool tf_flowing_keeps(const tf_flowing *of, tf_operation operation);

//: Declare the passes of a flow
/// Each goes once through the surface, and returns TF_OK or what went wrong.
tf_status tf_refine_pass(tf_flowing *of);
tf_status tf_turn_pass(tf_flowing *of);
tf_status tf_coarsen_pass(tf_flowing *of);
tf_status tf_relax_pass(tf_flowing *of);

/// Moves all vertices along the velocity.
tf_status tf_advect(tf_flowing *of, double time, double step);

//: Declare how volume is given back
/// Moves vertices along their normals, one after the other, such that in all 1/6
/// of `more` is gained; less if a move is refused.
tf_status tf_flowing_give(tf_flowing *of, double more, int count,
                          const int vertex[]);
