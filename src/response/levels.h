//: Declare the levels of a response
#pragma once

#include "response/options.h"
#include "response/resolver_memory.h"

/// A step that is being resolved, with everything that resolving it needs.
typedef struct tf_resolution {
    tf_resolver *resolver;
    tf_response_options options; ///< with the defaults filled in
    tf_step step;
    tf_motion motion;         ///< from the start to the end so far
    tf_contact_search search; ///< of this motion
    tf_contact_rule rule;
    tf_contacts contacts; ///< those of this motion
    tf_zone_statistics zones;
    tf_response_report report;
} tf_resolution;

/// If the motion has no contacts, lists in their place the pairs that it brings
/// nearer than the thickness, if there is one, and counts them.  Sets the error to
/// what it returns.
tf_status tf_resolution_find_near(tf_resolution *resolution, tf_error *error);

/// Answers the contacts, level by level, until none are left.  Returns TF_OK or
/// TF_OUT_OF_MEMORY.
tf_status tf_respond(tf_resolution *resolution);
