//: Declare what a flow holds
#pragma once

#include "flow/advance.h"
#include "remesh/remesher.h"
#include "topology/reconnector.h"

/// The parts of a step, each with the memory that it keeps; they work on the
/// draft.
struct tf_flow {
    tf_adaptive_surface *surface;
    tf_adaptive_surface draft;
    tf_flow_report report;
    tf_response_report no_response;
    tf_remesher remesher;
    tf_reconnector reconnector;
    tf_flow_advance advance;
};
