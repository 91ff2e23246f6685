// Flows that do not keep the volume: to measure what keeping it is worth.
#ifndef SUPPORT_CARELESS_H
#define SUPPORT_CARELESS_H

#include "flow/flow.h"
#include "remesh/policy.h"

/// Keeps the volume but in some operations, a bit 1 << tf_operation each.
tf_remesh_policy careless_policy(unsigned operations);

/// Makes a step by such a policy, as tf_flow_step does; with a bit 1 <<
/// TF_OPERATIONS the advance does not keep the volume, either.  The report
/// counts no operations and has no times.
tf_status careless_step(tf_flow *flow, unsigned operations,
                        const tf_flow_options *options, double time,
                        double step, tf_flow_report *report);

#endif
