//: Declare what a flow holds
#pragma once

#include "flow/advance.h"
#include "remesh/remesher.h"
#include "topology/reconnector.h"

/// The parts of a step, each with the memory that it keeps.
struct tf_flow {
    tf_remesher remesher;
    tf_reconnector reconnector;
    tf_flow_advance advance;
};
