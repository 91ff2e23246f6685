//: Declare what a resolver holds
#pragma once

#include "distance/near_contacts.h"
#include "response/answer_list.h"
#include "response/failsafe.h"
#include "response/follow.h"
#include "response/options.h"
#include "response/rigid.h"
#include "response/zones.h"
#include "surface/pair_cache.h"

typedef struct tf_resolver {
    tf_surface *surface;
    tf_pair_cache pairs;
    tf_thickness thickness;
    tf_buffer end, unpushed, base, ones, displacement; ///< of the vertices
    tf_zones zones;
    tf_rigid rigid;
    tf_failsafe failsafe;
    tf_follow follow;
    tf_answer_list answers;
    tf_buffer origin;    ///< where a step started that may be answered again
    size_t origin_bytes; ///< of it; 0: the last step may not be
    tf_buffer part;      ///< of a part of the step: where vertices start, are
                         ///< proposed to end, and would be when the step ends
    tf_buffer flags; ///< a byte for each vertex, see tf_vertex_flag; and once
                     ///< more, of a part of the step
    tf_buffer
        followed;      ///< the fraction of its script that each vertex followed
    bool has_resolved; ///< the last call has resolved a step
    tf_response_report report; ///< of the last step, lent
} tf_resolver;

//: Declare the levels of a response
/// A step that is being resolved, with everything that resolving it needs.  It
/// may be taken in several parts, one after another; what is not said to be of
/// the whole step is of one part.
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

/// Finds the contacts of the motion among all pairs or, if it has none, the pairs
/// that it brings nearer than the thickness.  Sets the error to what it returns.
tf_status tf_resolution_detect(tf_resolution *resolution, tf_error *error);

/// Finds the contacts of the motion among the pairs that the last detection has
/// looked at.  If there are none, detects from the beginning, but not in a draft.
tf_status tf_resolution_detect_again(tf_resolution *resolution);

/// Answers the contacts, level by level, until none are left; in a draft, those
/// that impulses and zones can answer.  Returns TF_OK or TF_OUT_OF_MEMORY.
tf_status tf_respond(tf_resolution *resolution);
