// Flows that do not keep the volume: to measure what keeping it is worth.
#ifndef SUPPORT_CARELESS_H
#define SUPPORT_CARELESS_H

#include "flow/flow.h"
#include "remesh/policy.h"

enum {
    CARELESS_ADVANCE = TF_SMOOTH + 1, ///< the bit after those of operations
    CARELESS_BITS
};

/// Keeps the volume but in some operations, a bit 1 << tf_operation each.
tf_remesh_policy careless_policy(unsigned operations);

/// Makes a step by such a policy, as tf_flow_step does; with a bit 1 <<
/// CARELESS_ADVANCE the advance does not keep the volume, either.  The report
/// counts no operations and has no times.
tf_status careless_step(tf_flow *flow, unsigned operations, double time,
                        double step, const tf_flow_options *options,
                        const tf_flow_report **report);

#endif
