//: Declare the levels of a response
#pragma once

#include "response/options.h"
#include "response/resolver_memory.h"

/// A step that is being resolved, with everything that resolving it needs.  It
/// may be taken in several parts, one after another; what is not said to be of the
/// whole step is of one part.
typedef struct tf_resolution {
    tf_resolver *resolver;
    tf_response_options options;    ///< with the defaults filled in
    const double *start, *proposed; ///< of the whole step
    int parts;
    double smallest_gap;      ///< of the whole step
    tf_response_report whole; ///< of the whole step
    tf_step step;
    tf_motion motion;         ///< from the start to the end so far
    tf_contact_search search; ///< of this motion
    tf_contact_rule rule;
    tf_contacts contacts; ///< those of this motion
    tf_zone_statistics zones;
    tf_response_report report;
} tf_resolution;

/// Answers the contacts, level by level, until none are left.  Returns TF_OK or
/// TF_OUT_OF_MEMORY.
tf_status tf_respond(tf_resolution *resolution);
